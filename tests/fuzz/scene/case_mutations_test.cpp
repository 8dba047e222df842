// Whatever is done to the text of a case, reading it gives a case or refuses it with located errors: it never
// crashes, hangs or lets another exception out. Mutations are drawn from a seeded generator; a failure prints
// the text.

#include "read_or_refused.hpp"

#include "scene/case.hpp"
#include "scene/plan/plan.hpp"

#include <cmath>
#include <filesystem>

namespace tremolo::scene {
namespace {

/// A file, from the root of the source.
class CaseFuzz : public ::testing::TestWithParam<const char*> {};

TEST_P(CaseFuzz, MutationsAreReadOrRefused) {
  const std::filesystem::path file = std::filesystem::path(TREMOLO_SOURCE_DIR) / GetParam();
  testing::expect_read_or_refused(file, 20240119, 2000, [&](const std::string& text) {
    const auto planned = plan(parse(text, "case.toml", file.parent_path()));
    EXPECT_TRUE(std::isfinite(planned.dt) && planned.dt > 0.0) << text;
  });
}

INSTANTIATE_TEST_SUITE_P(Cases, CaseFuzz,
                         ::testing::Values("cases/halfspace_box/case.toml", "cases/slope_oblique/case.toml",
                                           "cases/strip_footing/case.toml",
                                           "tests/fuzz/scene/structures.toml"));

} // namespace
} // namespace tremolo::scene
