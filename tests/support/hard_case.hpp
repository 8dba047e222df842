#pragma once

// Hard cases: what is measured is asserted against its bound and, where the environment variable
// TREMOLO_HARD_CASES names a file, appended to it as a row
//
//     suite, test, kind, what, measured, relation, bound, unit        (separated by tabs)
//
// from which tests/stability/table.py makes the tables of docs/stability.md, and tests/acceptance/table.py
// that of docs/validation/acceptance.md.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

namespace tremolo::test_support {

namespace hard_case {

inline void add_row(std::string_view kind, std::string_view what, double measured, std::string_view relation,
                    double bound, std::string_view unit) {
  const char* const file = std::getenv("TREMOLO_HARD_CASES");
  if (file == nullptr)
    return;
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::string row = fmt::format("{}\t{}\t{}\t{}\t{:.9g}\t{}\t{:.9g}\t{}\n", test.test_suite_name(),
                                      test.name(), kind, what, measured, relation, bound, unit);
  std::ofstream(file, std::ios::app) << row << std::flush;
}

} // namespace hard_case

/// The measured value must stay below its bound.
inline void bounded(std::string_view what, double measured, double bound, std::string_view unit = "") {
  hard_case::add_row("bound", what, measured, "<", bound, unit);
  EXPECT_LT(measured, bound) << what << (unit.empty() ? "" : ", ") << unit;
}

/// It must reach its bound.
inline void reaches(std::string_view what, double measured, double bound, std::string_view unit = "") {
  hard_case::add_row("bound", what, measured, ">=", bound, unit);
  EXPECT_GE(measured, bound) << what << (unit.empty() ? "" : ", ") << unit;
}

/// What must be the same to the last bit, or not at all.
inline void exactly(std::string_view what, double measured, double expected, std::string_view unit = "") {
  hard_case::add_row("bound", what, measured, "=", expected, unit);
  EXPECT_EQ(measured, expected) << what << (unit.empty() ? "" : ", ") << unit;
}

/// A bound that every case keeps (conservation_monitor.hpp).
inline void monitored(std::string_view what, double measured, double bound, std::string_view unit = "") {
  hard_case::add_row("monitor", what, measured, "<", bound, unit);
  EXPECT_LT(measured, bound) << what << (unit.empty() ? "" : ", ") << unit;
}

/// A variant that is known to be wrong must break the bound, or the case could not tell.
inline void breaks(std::string_view variant, double measured, double bound, std::string_view unit = "") {
  hard_case::add_row("wrong", variant, measured, ">", bound, unit);
  EXPECT_GT(measured, bound) << variant << (unit.empty() ? "" : ", ") << unit;
}

/// A variant that is known to be wrong must not reach the bound.
inline void misses(std::string_view variant, double measured, double bound, std::string_view unit = "") {
  hard_case::add_row("wrong", variant, measured, "<", bound, unit);
  EXPECT_LT(measured, bound) << variant << (unit.empty() ? "" : ", ") << unit;
}

} // namespace tremolo::test_support
