// Refusals of the hysteretic laws and of soil curves name the value and the allowed range.

#include "materials/hysteretic/backbone/curve_fit.hpp"
#include "materials/law/law.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

namespace tremolo::materials {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const Elasticity elastic = {1900.0, 130e6, 0.3};

std::string refusal(const std::function<void()>& attempt) {
  try {
    attempt();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(HystereticParameters, OutsideTheirRangeAreRefused) {
  const auto masing = [](double reference, double beta, double exponent) {
    return refusal([=] { validate(Law(MasingShear{elastic, reference, beta, exponent})); });
  };
  EXPECT_EQ(masing(5e-4, 1.4, 0.8), "accepted");
  EXPECT_EQ(masing(0.0, 1.0, 1.0), "reference_strain = 0 is out of range, must be > 0");
  EXPECT_EQ(masing(5e-4, -1.0, 1.0), "beta = -1 is out of range, must be > 0");
  EXPECT_EQ(masing(5e-4, 1.0, 1.2), "exponent = 1.2 is out of range, must be in [0.1, 1]");
  EXPECT_THAT(masing(std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0),
              HasSubstr("reference_strain = nan"));
  const auto iwan = [](const IwanFit& fit) {
    return refusal([&] { iwan_shear(elastic, 5e-4, 1.0, 0.9, fit); });
  };
  EXPECT_EQ(iwan({}), "accepted");
  EXPECT_EQ(iwan({.elements = 30}), "elements = 30 must be a multiple of 4 in [4, 60]");
  EXPECT_EQ(iwan({.largest_strain = 0.0}), "largest_strain = 0 is outside [1e-06, 10]");
  IwanShear weak = iwan_shear(elastic, 5e-4, 1.0, 0.9);
  EXPECT_NO_THROW(validate(Law(weak)));
  weak.elements[3].shear_modulus *= 0.5;
  EXPECT_THAT(refusal([&] { validate(Law(weak)); }), HasSubstr("sum of the Iwan elements' shear moduli"));
}

TEST(HystereticParameters, EveryStateVariableHasANameOfItsOwn) {
  for (const Law& law : {Law(MasingShear{elastic, 5e-4}), Law(iwan_shear(elastic, 5e-4, 1.0, 0.9))}) {
    std::set<std::string_view> names;
    for (const StateVariable& variable : state_variables(law)) {
      EXPECT_TRUE(names.insert(variable.name).second) << variable.name;
    }
    const std::size_t expected = name(law) == "masing_shear" ? masing_history_size : 3 * IwanFit{}.elements;
    EXPECT_EQ(names.size(), expected);
  }
}

TEST(SoilCurves, OutOfOrderOrRangeAreRefused) {
  const auto table = [](const SoilCurves& curves) { return refusal([&] { validate(curves); }); };
  EXPECT_EQ(table({{1e-5, 1e-3}, {1.0, 0.4}, {0.01, 0.15}}), "accepted");
  EXPECT_THAT(
      table({{1e-3, 1e-5}, {1.0, 0.4}, {0.01, 0.15}}),
      AllOf(HasSubstr("row 2"), HasSubstr("strain = 1e-05"), HasSubstr("above that of the row before")));
  EXPECT_THAT(table({{1e-3, 10.0}, {1.0, 0.4}, {0.01, 0.15}}),
              AllOf(HasSubstr("not per cent"), HasSubstr("= 10 is outside")));
  EXPECT_THAT(table({{1e-5, 1e-3}, {0.9, 0.95}, {0.01, 0.15}}),
              HasSubstr("row 2 of the soil curve: G/Gmax = 0.95"));
  EXPECT_THAT(table({{1e-5, 1e-3}, {1.0, 0.4}, {1.0, 15.0}}), HasSubstr("damping ratio (not per cent) = 15"));
  EXPECT_THAT(table({{1e-5, 1e-3}, {1.0}, {0.01, 0.15}}), HasSubstr("2 strains, 1 modulus ratios"));
  EXPECT_THAT(refusal([] {
                fit_mkz({{1e-5, 1e-3}, {1.0, 1.0}, {0.0, 0.0}});
              }),
              HasSubstr("no reduction to fit"));
  EXPECT_THAT(refusal([] { darendeli_curves({.mean_effective_stress = 0.0}); }),
              HasSubstr("mean_effective_stress = 0 is outside [100, 1e+08]"));
}

} // namespace
} // namespace tremolo::materials
