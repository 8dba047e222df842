#include "materials/law.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace tremolo::materials {
namespace {

using testing::HasSubstr;

MohrCoulomb good() {
  MohrCoulomb soil;
  soil.elastic = {1700.0, 40e6, 0.28};
  soil.cohesion_peak = 4e3;
  soil.friction_peak = 0.8;
  soil.friction_residual = 0.5;
  soil.softening = 15.0;
  return soil;
}

std::string refusal(const std::function<void(MohrCoulomb&)>& spoil) {
  MohrCoulomb soil = good();
  spoil(soil);
  try {
    validate(soil);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Parameters, OfASoundSoilAreAccepted) {
  EXPECT_NO_THROW(validate(Law(good())));
}

TEST(Parameters, AreRefusedWithNameValueAndRange) {
  EXPECT_THAT(refusal([](auto& s) { s.elastic.young = -1.0; }), HasSubstr("young = -1 must be positive"));
  EXPECT_THAT(refusal([](auto& s) { s.elastic.poisson = 0.5; }),
              HasSubstr("poisson = 0.5 is outside (-1, 0.5)"));
  EXPECT_THAT(refusal([](auto& s) { s.elastic.density = 0.0; }), HasSubstr("density = 0 must be positive"));
  EXPECT_THAT(refusal([](auto& s) { s.cohesion_residual = 5e3; }), HasSubstr("cohesion_residual = 5000"));
  EXPECT_THAT(refusal([](auto& s) { s.friction_peak = 45.0; }), HasSubstr("friction_peak = 45"));
  EXPECT_THAT(refusal([](auto& s) { s.friction_residual = 0.9; }), HasSubstr("friction_residual = 0.9"));
  EXPECT_THAT(refusal([](auto& s) { s.dilation_peak = 0.9; }), HasSubstr("dilation_peak = 0.9"));
  EXPECT_THAT(refusal([](auto& s) { s.softening = -1.0; }), HasSubstr("softening = -1"));
  EXPECT_THAT(refusal([](auto& s) { s.tension_cutoff = -1.0; }), HasSubstr("tension_cutoff = -1"));
  EXPECT_THAT(refusal([](auto& s) { s.friction_residual = 0.0; }), HasSubstr("no strength"));
}

TEST(Parameters, NotANumberIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal([=](auto& s) { s.cohesion_peak = nan; }), HasSubstr("cohesion_peak = nan"));
  EXPECT_THAT(refusal([=](auto& s) { s.softening = nan; }), HasSubstr("softening = nan"));
  EXPECT_THAT(refusal([=](auto& s) { s.elastic.young = nan; }), HasSubstr("young = nan"));
}

TEST(Law, DescribesItself) {
  const Law soil = good();
  EXPECT_EQ(name(soil), "mohr_coulomb");
  ASSERT_EQ(state_variables(soil).size(), 1U);
  EXPECT_EQ(state_variables(soil)[equivalent_plastic_strain].name, "equivalent_plastic_strain");
  EXPECT_EQ(name(LinearElastic{}), "linear_elastic");
  EXPECT_TRUE(state_variables(LinearElastic{}).empty());
}

TEST(Law, WithoutSofteningOnlyDropsTheSoftening) {
  const Law held = without_softening(Law(good()));
  EXPECT_EQ(std::get<MohrCoulomb>(held).softening, 0.0);
  EXPECT_EQ(std::get<MohrCoulomb>(held).friction_peak, good().friction_peak);
}

} // namespace
} // namespace tremolo::materials
