#include "materials/law/law.hpp"
#include "materials/tensor/sine_cosine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tremolo::materials {
namespace {

using testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180.0;

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
  EXPECT_THAT(refusal([](auto& s) { s.cohesion_residual = 5e3; }),
              HasSubstr("cohesion_residual = 5000 Pa is above cohesion_peak = 4000 Pa"));
  EXPECT_THAT(refusal([](auto& s) { s.friction_peak = 100.0 * degree; }),
              HasSubstr("friction_peak_deg = 100 degrees is out of range, must be in [0, 89] degrees"));
  EXPECT_THAT(refusal([](auto& s) { s.friction_residual = 50.0 * degree; }),
              HasSubstr("friction_residual_deg = 50 degrees is above friction_peak_deg"));
  EXPECT_THAT(refusal([](auto& s) { s.dilation_peak = 50.0 * degree; }),
              HasSubstr("dilation_peak_deg = 50 degrees is above friction_peak_deg"));
  EXPECT_THAT(refusal([](auto& s) { s.softening = -1.0; }),
              HasSubstr("softening = -1 is out of range, must be >= 0"));
  EXPECT_THAT(refusal([](auto& s) { s.tension_cutoff = -1.0; }), HasSubstr("tension_cutoff = -1 Pa"));
  EXPECT_THAT(refusal([](auto& s) { s.friction_residual = 0.0; }), HasSubstr("no strength"));
}

TEST(Parameters, NotANumberIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal([=](auto& s) { s.cohesion_peak = nan; }), HasSubstr("cohesion_peak = nan Pa"));
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
  EXPECT_EQ(name(DruckerPrager{}), "drucker_prager");
  EXPECT_EQ(state_variables(DruckerPrager{}).size(), 1U);
  const Law clay = multi_yield_clay({1700.0, 60e6, 0.49}, 40e3);
  EXPECT_EQ(name(clay), "multi_yield_clay");
  EXPECT_EQ(state_variables(clay).size(), 60U);
  EXPECT_EQ(name(without_softening(clay)), "linear_elastic");
  EXPECT_TRUE(traits(clay).three_dimensional);
}

double listed(const Law& law, std::string_view wanted) {
  for (const ParameterValue& one : parameters(law)) {
    if (one.name == wanted) {
      EXPECT_FALSE(one.unit.empty());
      EXPECT_FALSE(one.meaning.empty());
      EXPECT_FALSE(one.origin.empty());
      return one.value;
    }
  }
  ADD_FAILURE() << name(law) << " lists no " << wanted;
  return 0.0;
}

TEST(Law, ListsItsParameters) {
  const Elasticity elastic = {1700.0, 40e6, 0.28};
  EXPECT_NEAR(listed(LinearElastic{elastic}, "shear_modulus"), 15.625e6, 1e-3);
  EXPECT_EQ(listed(good(), "softening"), 15.0);
  EXPECT_NEAR(listed(good(), "tension_cutoff"), 4e3 / std::tan(0.8), 1e-9); // the apex, none being given
  EXPECT_EQ(listed(DruckerPrager{elastic, 4e3, 0.5, 0.0, ConeMatch::plane_strain}, "cohesion"), 4e3);
  EXPECT_NEAR(listed(DruckerPrager{elastic, 4e3, 0.5, 0.0, ConeMatch::plane_strain}, "eta"), std::sin(0.5),
              1e-15);
  EXPECT_EQ(listed(multi_yield_clay(elastic, 40e3), "undrained_strength"), 40e3);
  EXPECT_EQ(listed(MasingShear{elastic, 5e-4, 1.0, 0.9}, "exponent"), 0.9);
  EXPECT_NEAR(listed(iwan_shear(elastic, 5e-4, 1.0, 1.0), "largest_strain"), 0.1, 1e-6);
}

/// Up to a quarter turn to either side, against the C library.
TEST(SineCosine, AgreesWithTheLibrary) {
  for (int k = -100000; k <= 100000; ++k) {
    const double angle = 1.5707963267948966 * k / 100000.0;
    const SineCosine both = sine_cosine(angle);
    EXPECT_NEAR(both.sine, std::sin(angle), 5e-16 * std::abs(std::sin(angle)));
    EXPECT_NEAR(both.cosine, std::cos(angle), 5e-16);
  }
}

TEST(Law, WithoutSofteningOnlyDropsTheSoftening) {
  const Law held = without_softening(Law(good()));
  EXPECT_EQ(std::get<MohrCoulomb>(held).softening, 0.0);
  EXPECT_EQ(std::get<MohrCoulomb>(held).friction_peak, good().friction_peak);
}

} // namespace
} // namespace tremolo::materials
