// Whatever is done to the text of a case, reading it gives a case or refuses it with located errors: it never
// crashes, hangs or lets another exception out. Mutations are drawn from a seeded generator; a failure prints
// the text.

#include "read_or_refused.hpp"

#include "scene/case.hpp"
#include "scene/plan/plan.hpp"

#include <cmath>

namespace tremolo::scene {
namespace {

class CaseFuzz : public ::testing::TestWithParam<const char*> {};

TEST_P(CaseFuzz, MutationsAreReadOrRefused) {
  const std::string folder = std::string(TREMOLO_SOURCE_DIR "/cases/") + GetParam();
  testing::expect_read_or_refused(folder + "/case.toml", 20240119, 2000, [&](const std::string& text) {
    const auto planned = plan(parse(text, "case.toml", folder));
    EXPECT_TRUE(std::isfinite(planned.dt) && planned.dt > 0.0) << text;
  });
}

INSTANTIATE_TEST_SUITE_P(Shipped, CaseFuzz, ::testing::Values("halfspace_box", "slope_oblique"));

} // namespace
} // namespace tremolo::scene
