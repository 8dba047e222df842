#include "case_text.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(MohrCoulombSoil, HasNoMoreStrengthLeftThanAtThePeak) {
  const auto soil = [](const char* residual_friction, const char* dilation) {
    return with("model = \"linear_elastic\"",
                std::string("model = \"mohr_coulomb\"\ncohesion_peak = 4e3\n"
                            "cohesion_residual = 0.0\nfriction_peak_deg = 30.0\n"
                            "softening = 15.0\nreference_size = 1.0\nfriction_residual_deg = ") +
                    residual_friction + "\ndilation_peak_deg = " + dilation);
  };
  EXPECT_THAT(errors_of(soil("28.0", "5.0")), IsEmpty());
  EXPECT_THAT(errors_of(soil("35.0", "5.0")),
              ElementsAre("case.toml:20:25: [soil.sand] 'friction_residual_deg' = 35 is above "
                          "'friction_peak_deg' = 30"));
  EXPECT_THAT(
      errors_of(soil("28.0", "40.0")),
      ElementsAre("case.toml:21:21: [soil.sand] 'dilation_peak_deg' = 40 is above 'friction_peak_deg' = 30"));
  EXPECT_THAT(errors_of(soil("0.0", "0.0")),
              ElementsAre("case.toml:20:25: [soil.sand] 'friction_residual_deg' and "
                          "'cohesion_residual' are both 0: the soil would have no strength"));
}

} // namespace
} // namespace tremolo::scene::testing
