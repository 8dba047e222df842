#pragma once

// What a row of known limits expects, written into the table of acceptance as well.

#include "tests/support/hard_case.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace tremolo::mpm_domain::test {

/// @param share     of the limit: of its load, its factor of safety, or the strength that just suffices
/// @param expected  whether the model carries its weight there
template <class Model>
void expect_stands(const Model& model, double share, bool expected) {
  test_support::exactly(
      fmt::format("{} at {:g} of the limit: stands (1) or fails (0)", testing::PrintToString(model), share),
      stands(model, share), expected);
}

} // namespace tremolo::mpm_domain::test
