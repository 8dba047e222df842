// Whatever is done to the text of a case, reading it gives a case or refuses it with located errors: it never
// crashes, hangs or lets another exception out. Mutations are drawn from a seeded generator; a failure prints
// the text.

#include "read_or_refused.hpp"

#include "scene/case.hpp"
#include "scene/plan/plan.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/repetitions.hpp"

#include <cmath>
#include <filesystem>

namespace tremolo::scene {
namespace {

void expect_cases_or_errors(const std::filesystem::path& file, std::size_t rounds, double least) {
  testing::expect_read_or_refused(
      file, 20240119, rounds,
      [&](const std::string& text) {
        const auto planned = plan(parse(text, "case.toml", file.parent_path()));
        EXPECT_TRUE(std::isfinite(planned.dt) && planned.dt > 0.0) << text;
      },
      least);
}

class CaseFuzz : public ::testing::TestWithParam<const char*> {};

TEST_P(CaseFuzz, MutationsAreReadOrRefused) {
  expect_cases_or_errors(source_dir() + "/cases/" + GetParam() + "/case.toml",
                         test_support::repetitions(std::size_t{600}), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Shipped, CaseFuzz, ::testing::Values("halfspace_box", "slope_oblique"));

/// All keys of structures, and nothing that may change without harm.
TEST(StructureFuzz, MutationsAreReadOrRefused) {
  expect_cases_or_errors(source_dir() + "/tests/fuzz/scene/structures.toml", 2000, 0.005);
}

} // namespace
} // namespace tremolo::scene
