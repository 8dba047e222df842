#include "freefield/column_mesh.hpp"
#include "freefield/profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;

const Elasticity soft = Elasticity::from_wave_speeds(1700.0, 150.0, 320.0);
const Elasticity rock = Elasticity::from_wave_speeds(2200.0, 800.0, 1500.0);

Profile profile() {
  return {2.0, {{8.0, soft, 0.05}, {22.0, rock, 0.01}}, rock};
}

/// Damping ratio of harmonic motion at a frequency.
double ratio_at(const DampingCoefficients& c, double frequency_hz) {
  const double w = 2.0 * std::numbers::pi * frequency_hz;
  return c.alpha / (2.0 * w) + c.beta * w / 2.0;
}

void expect_refused(const Profile& wrong, const std::string& words) {
  EXPECT_THAT([&] { validate(wrong); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr(words)));
}

TEST(Damping, RayleighGivesTheRatioAtBothFrequencies) {
  const auto c = coefficients(RayleighDamping{1.0, 6.0}, 0.05);
  EXPECT_NEAR(ratio_at(c, 1.0), 0.05, 1e-15);
  EXPECT_NEAR(ratio_at(c, 6.0), 0.05, 1e-15);
  EXPECT_LT(ratio_at(c, 2.5), 0.05);
}

TEST(Damping, KelvinVoigtGrowsWithFrequencyFromTheReference) {
  const auto c = coefficients(KelvinVoigtDamping{2.0}, 0.02);
  EXPECT_NEAR(ratio_at(c, 2.0), 0.02, 1e-15);
  EXPECT_NEAR(ratio_at(c, 6.0), 0.06, 1e-15);
}

TEST(Damping, RefusesFrequenciesOutOfOrder) {
  EXPECT_THROW(validate(RayleighDamping{3.0, 3.0}), std::invalid_argument);
  EXPECT_THROW(validate(RayleighDamping{0.0, 3.0}), std::invalid_argument);
  EXPECT_THROW(validate(KelvinVoigtDamping{0.0}), std::invalid_argument);
}

TEST(ProfileValidation, NamesTheLayerAndTheValue) {
  Profile wrong = profile();
  wrong.layers[1].thickness = -22.0;
  expect_refused(wrong, "layer 2 from the top: thickness is -22");
  wrong = profile();
  wrong.layers[0].damping_ratio = 1.0;
  expect_refused(wrong, "layer 1 from the top: damping ratio is 1, must be in [0, 1)");
  wrong = profile();
  wrong.half_space.young = std::numeric_limits<double>::quiet_NaN();
  expect_refused(wrong, "half-space: Young's modulus is nan");
  wrong = profile();
  wrong.layers[0].soil.poisson = 0.5;
  expect_refused(wrong, "Poisson's ratio is 0.5, must be in (-1, 0.5)");
  wrong = profile();
  wrong.layers.clear();
  expect_refused(wrong, "no layer");
}

TEST(ColumnMesh, HasNodesAtInterfacesAndElementsNoLongerThanAsked) {
  const ColumnMesh mesh = mesh_profile(profile(), 3.0);
  EXPECT_EQ(mesh.elements(), 3U + 8U); // 8/3 and 22/3, rounded up
  EXPECT_DOUBLE_EQ(mesh.node_y.front(), -28.0);
  EXPECT_DOUBLE_EQ(mesh.node_y[8], -6.0);
  EXPECT_DOUBLE_EQ(mesh.node_y.back(), 2.0);
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    EXPECT_GT(mesh.length(e), 0.0);
    EXPECT_LE(mesh.length(e), 3.0);
    EXPECT_EQ(mesh.element_layer[e], e < 8 ? 1U : 0U);
  }
}

TEST(ColumnMesh, TakesNoExtraElementForRounding) {
  Profile thin = profile();
  thin.layers = {{0.3, soft, 0.0}}; // 0.3 / 0.1 is above 3 in floating point
  EXPECT_EQ(mesh_profile(thin, 0.1).elements(), 3U);
}

TEST(ColumnMesh, FindsTheElementAboveANode) {
  const ColumnMesh mesh = mesh_profile(profile(), 3.0);
  EXPECT_EQ(mesh.at(-6.0).element, 8U);
  EXPECT_DOUBLE_EQ(mesh.at(-6.0).fraction, 0.0);
  EXPECT_EQ(mesh.at(2.0).element, 10U);
  EXPECT_DOUBLE_EQ(mesh.at(2.0).fraction, 1.0);
  EXPECT_EQ(mesh.at(-28.0).element, 0U);
  EXPECT_THROW(mesh.at(2.001), std::invalid_argument);
  EXPECT_THROW(mesh.at(-28.001), std::invalid_argument);
  EXPECT_THROW(mesh.at(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

TEST(ColumnMesh, RefusesElementSizesThatMakeNoMesh) {
  EXPECT_THROW(mesh_profile(profile(), 0.0), std::invalid_argument);
  EXPECT_THROW(mesh_profile(profile(), -1.0), std::invalid_argument);
  EXPECT_THROW(mesh_profile(profile(), 1e-9), std::invalid_argument);
}

} // namespace
