// Which ground the base of a model stands for, by where the box ends in the profile.

#include "case_text.hpp"

#include "scene/plan/layers.hpp"
#include "scene/plan/plan.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tremolo::scene::testing {
namespace {

/// The flat case, 10 m of soil, over layers of the given thickness: 1800 kg/m3 above, 1900 kg/m3 below, and a
/// half-space of 1700 kg/m3.
Case on_layers(double upper, double lower) {
  const auto layer = [](double thickness, double density) {
    return "[[profile]]\nthickness = " + std::to_string(thickness) +
           "\ndensity = " + std::to_string(density) + "\nyoung = 40e6\npoisson = 0.28\n";
  };
  const std::string depth = std::to_string(-upper - lower);
  return parse_case(with("reference = [0.0, -10.0]", "reference = [0.0, " + depth + "]",
                         plus(layer(upper, 1800.0) + layer(lower, 1900.0))));
}

TEST(GroundBelowBase, IsTheHalfSpaceFromItsTopOn) {
  EXPECT_EQ(ground_below_base(parse_case(std::string(flat_case)))->density, 1700.0);
  EXPECT_EQ(ground_below_base(on_layers(4.0, 6.0))->density,
            1700.0); // 10 m of layers: the base is at their end
  EXPECT_EQ(ground_below_base(on_layers(4.0, 2.0))->density, 1700.0);
}

TEST(GroundBelowBase, IsTheNextLayerAtAnInterface) {
  EXPECT_EQ(ground_below_base(on_layers(10.0, 5.0))->density, 1900.0);
}

TEST(GroundBelowBase, IsTheSoilItselfWithinALayer) {
  EXPECT_FALSE(ground_below_base(on_layers(4.0, 20.0)));
}

TEST(GroundBelowBase, ShortensTheStepOfAMatchedLayerInRock) {
  const auto rock = [](std::string_view base) {
    return plan(parse_case(with("base = { model = \"wave\", form = \"total\" }", base,
                                with("young = 40e6", "young = 640e6"))))
        .critical_dt;
  };
  const double dashpots = rock("base = { model = \"wave\", form = \"total\" }");
  const double layer = rock("base = { model = \"wave\", form = \"total\", absorber = \"matched_layer\" }");
  EXPECT_NEAR(layer, 0.25 * dashpots, 1e-12); // four times the wave speed
}

} // namespace
} // namespace tremolo::scene::testing
