// The rules of what ground weighs, of water in it, and of the ground that the free fields have beside it:
// each with a case that keeps it and one that breaks it. Limits of K0 are compared with closed forms:
// Rankine's of Mohr-Coulomb, 1 -+ sqrt(3) s_u/sigma'_v of von Mises surfaces in triaxial states.

#include "rule_cases.hpp"

#include "scene/plan/plan.hpp"
#include "scene/soils/stress_at_rest.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// The flat case under gravity with its soil given anew, and layers that name it; 10 m deep, sides and base
/// "fe".
std::string ground(const std::string& soil, const std::string& more = "", const std::string& water = "") {
  std::string text = with_columns(with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]"));
  text = with("model = \"linear_elastic\"\ndensity = 1700.0\nyoung = 40e6\npoisson = 0.28\n", soil, text);
  return text + "[[profile]]\nthickness = 10.0\nsoil = \"sand\"\n" + water + more;
}

std::string mohr_coulomb(double cohesion, double friction, const std::string& more = "") {
  return fmt::format(
      "model = \"mohr_coulomb\"\ndensity = 1700.0\nyoung = 40e6\npoisson = 0.3\ncohesion_peak = {0}\n"
      "cohesion_residual = {0}\nfriction_peak_deg = {1}\nfriction_residual_deg = {1}\nsoftening = 0.0\n{2}",
      cohesion, friction, more);
}

const std::string pm4sand = "library = \"pm4sand_dr55\"\npermeability = 1e-4\n";
const std::string table = "[water]\nlevel = 0.0\n";

/// Sides and base of the domain's own cells, which sand needs.
std::string with_mpm_columns(std::string text) {
  for (const auto* side : {"left = ", "right = ", "base = "})
    text = with(std::string(side) + "{ model = \"fe\"", std::string(side) + "{ model = \"mpm\"", text);
  return text;
}

TEST(RestLimits, AreThoseOfRankine) {
  const double sine = std::sin(30.0 * std::numbers::pi / 180.0);
  const double cosine = std::cos(30.0 * std::numbers::pi / 180.0);
  const double vertical = 1e5;
  const double cohesion = 5e3;
  const materials::MohrCoulomb law{.elastic = {1700.0, 40e6, 0.3},
                                   .cohesion_peak = cohesion,
                                   .cohesion_residual = cohesion,
                                   .friction_peak = 30.0 * std::numbers::pi / 180.0,
                                   .friction_residual = 30.0 * std::numbers::pi / 180.0};
  const auto limits = rest_limits(law, vertical);
  ASSERT_TRUE(limits);
  EXPECT_NEAR(limits->active, (1.0 - sine - 2.0 * cohesion / vertical * cosine) / (1.0 + sine), 1e-9);
  EXPECT_NEAR(limits->passive, (1.0 + sine + 2.0 * cohesion / vertical * cosine) / (1.0 - sine), 1e-9);
}

TEST(RestLimits, OfClayAreThoseOfVonMises) {
  const auto law = materials::multi_yield_clay({1700.0, 40e6, 0.49}, 20e3);
  const auto limits = rest_limits(law, 1e5);
  ASSERT_TRUE(limits);
  EXPECT_NEAR(limits->active, 1.0 - std::sqrt(3.0) * 0.2, 1e-9);
  EXPECT_NEAR(limits->passive, 1.0 + std::sqrt(3.0) * 0.2, 1e-9);
  EXPECT_FALSE(rest_limits(materials::LinearElastic{{1700.0, 40e6, 0.3}}, 1e5));
}

TEST(Rules, StressAtRestIsCarried) {
  const auto k0 = [](double value) {
    return errors_of(ground(mohr_coulomb(0.0, 30.0, fmt::format("rest_coefficient = {}\n", value))));
  };
  // Rankine's limits of 30 degrees are 1/3 and 3.
  EXPECT_THAT(k0(0.34), IsEmpty());
  EXPECT_THAT(k0(2.9), IsEmpty());
  EXPECT_THAT(k0(3.1),
              ElementsAre(AllOf(HasSubstr("[soil.sand] 'rest_coefficient' is beyond the strength: K0 = 3.1"),
                                HasSubstr("mobilises 30.8 degrees"), HasSubstr("K0 from 0.333333 to 3 "))));
  EXPECT_THAT(k0(0.3), ElementsAre(HasSubstr("'rest_coefficient' is beyond the strength: K0 = 0.3 ")));
}

TEST(Rules, StressAtRestIsCarriedBySandThatLiquefies) {
  const auto k0 = [](double value) {
    return errors_of(
        with_mpm_columns(ground(pm4sand + fmt::format("rest_coefficient = {}\n", value), "", table)));
  };
  EXPECT_THAT(k0(9.9), ElementsAre(AllOf(HasSubstr("'rest_coefficient' is beyond the strength: K0 = 9.9"),
                                         HasSubstr("mobilises 54.7 degrees"))));
  EXPECT_THAT(k0(3.0), IsEmpty());
  EXPECT_THAT(k0(0.5), IsEmpty());
}

TEST(Rules, AStrengthInKilopascalsCannotHoldTheSoil) {
  // Friction angle 0: K0 = 3/7 of Poisson's ratio asks for (1 - K0) sigma_v/2 = 46 kPa of cohesion at the
  // base.
  EXPECT_THAT(errors_of(ground(mohr_coulomb(60e3, 0.0))), IsEmpty());
  EXPECT_THAT(errors_of(ground(mohr_coulomb(60.0, 0.0))),
              ElementsAre(AllOf(HasSubstr("[soil.sand] the strength cannot hold the soil's own weight"),
                                HasSubstr("60 kPa would be 60000"))));
  // Clay begins with its geostatic stress in a column "fe" under water alone; its skeleton has K0 = 0.98.
  const auto clay = [](const char* strength) {
    return errors_of(
        ground(std::string("model = \"multi_yield_clay\"\nporosity = 0.5\nvs = 150.0\nvp = 1500.0\n"
                           "drainage = \"undrained\"\nundrained_strength = ") +
                   strength + "\n",
               "", table));
  };
  EXPECT_THAT(clay("25.0"), ElementsAre(AllOf(HasSubstr("cannot hold the soil's own weight"),
                                              HasSubstr("25 kPa would be 25000"))));
  EXPECT_THAT(clay("25e3"), IsEmpty());
}

TEST(Rules, SoilHoldsItsWeight) {
  // Waves as free field: no column that refuses.
  const auto told = [](double cohesion) {
    std::string text = ground(mohr_coulomb(cohesion, 0.0));
    for (const auto* side : {"left = ", "right = ", "base = "})
      text = with(std::string(side) + "{ model = \"fe\"", std::string(side) + "{ model = \"wave\"", text);
    return remarks_of(text);
  };
  EXPECT_THAT(told(150.0), Contains(AllOf(HasSubstr("under which it yields in the gravity stage"),
                                          HasSubstr("150 kPa would be 150e3"))));
  EXPECT_THAT(told(40e3), Not(Contains(HasSubstr("own weight"))));
}

TEST(Rules, StressAtRestIsNearLimit) {
  const auto k0 = [](double value) {
    return remarks_of(ground(mohr_coulomb(0.0, 30.0, fmt::format("rest_coefficient = {}\n", value))));
  };
  EXPECT_THAT(k0(2.9), Contains(AllOf(HasSubstr("note: [soil.sand] 'rest_coefficient' is close to the limit"),
                                      HasSubstr("mobilises 29.2 degrees"))));
  EXPECT_THAT(k0(0.5), Not(Contains(HasSubstr("close to the limit"))));
}

const std::string linear = "model = \"linear_elastic\"\nyoung = 40e6\npoisson = 0.28\nporosity = 0.4\n";

TEST(Rules, WaterIsStifferThanSkeleton) {
  const auto told = [](const char* modulus) {
    return remarks_of(ground(linear + "permeability = 1e-4\n", "",
                             std::string("[water]\nlevel = 0.0\nbulk_modulus = ") + modulus + "\n"));
  };
  // M of the skeleton is 51.1 MPa, and so is K_f/n of 20.5 MPa.
  EXPECT_THAT(told("2.2e6"), Contains(AllOf(HasSubstr("[water] 'bulk_modulus' = 2.2e+06 Pa makes the water"),
                                            HasSubstr("softer than its skeleton, 5.11e+07 Pa"),
                                            HasSubstr("2.2e+06 kPa would be 2.2e+09"))));
  EXPECT_THAT(told("20e6"), Contains(HasSubstr("softer than its skeleton")));
  EXPECT_THAT(told("21e6"), Not(Contains(HasSubstr("softer than its skeleton"))));
}

TEST(Rules, DrainedSoilNeedsNoPermeability) {
  const auto told = [](const char* keys) { return remarks_of(ground(linear + keys, "", table)); };
  EXPECT_THAT(told("permeability = 1e-4\ndrainage = \"drained\"\n"),
              Contains(AllOf(HasSubstr("note: [soil.sand] 'permeability' = 0.0001 m/s is not used"),
                             HasSubstr("stays hydrostatic"))));
  EXPECT_THAT(told("permeability = 1e-4\ndrainage = \"undrained\"\n"), Contains(HasSubstr("is not used")));
  EXPECT_THAT(told("permeability = 1e-4\n"), Not(Contains(HasSubstr("is not used"))));
  EXPECT_THAT(told("drainage = \"drained\"\n"), Not(Contains(HasSubstr("is not used"))));
}

TEST(Rules, ARelativeDensityInPerCentDrawsOneMessage) {
  const std::string sand =
      "model = \"pm4sand\"\nshear_modulus_coefficient = 677.0\ncontraction_rate = 0.4\npermeability = "
      "1e-4\nrelative_density = ";
  EXPECT_THAT(errors_of(with_mpm_columns(ground(sand + "55\n", "", table))),
              ElementsAre(HasSubstr("'relative_density' = 55 is out of range, must be in [0.05, 1.2]")));
  EXPECT_THAT(errors_of(with_mpm_columns(ground(sand + "0.55\n", "", table))), IsEmpty());
}

TEST(Rules, WhatALawRefusesIsToldWithTheUnit) {
  const auto pressure = [](const char* value) {
    return errors_of(with_mpm_columns(ground(std::string("library = \"pdmy03_dr57\"\npermeability = 1e-4\n"
                                                         "reference_pressure = ") +
                                                 value + "\n",
                                             "", table)));
  };
  EXPECT_THAT(pressure("101"), ElementsAre(HasSubstr("101 kPa would be 101000")));
  EXPECT_THAT(pressure("101e3"), IsEmpty());
}

TEST(Rules, TheDensityOfSoilWithPoresIsTheSaturatedOne) {
  EXPECT_THAT(
      errors_of(ground(linear + "permeability = 1e-4\ndensity = 1.99\n", "", table)),
      ElementsAre(AllOf(HasSubstr("'density' = 1.99 contradicts"),
                        HasSubstr("the saturated density is meant"), HasSubstr("1.99 t/m3 would be 1990"))));
  EXPECT_THAT(errors_of(ground(linear + "permeability = 1e-4\ndensity = 1990.0\n", "", table)), IsEmpty());
}

/// Two soils, stiff below y = -5 m, in the regions; the layers as given.
std::string two_soils(const std::string& layers) {
  std::string text = with(
      "[[region]]\nsoil = \"sand\"\npolygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]\n",
      "[soil.stiff]\nmodel = \"linear_elastic\"\ndensity = 1900.0\nyoung = 160e6\npoisson = 0.28\n"
      "[[region]]\nsoil = \"stiff\"\npolygon = [[0.0, -10.0], [20.0, -10.0], [20.0, -5.0], [0.0, -5.0]]\n"
      "[[region]]\nsoil = \"sand\"\npolygon = [[0.0, -5.0], [20.0, -5.0], [20.0, 0.0], [0.0, 0.0]]\n");
  return text + layers;
}

std::string layers(const char* upper, double thickness, const char* lower) {
  return fmt::format(
      "[[profile]]\nthickness = {}\nsoil = \"{}\"\n[[profile]]\nthickness = {}\nsoil = \"{}\"\n", thickness,
      upper, 10.0 - thickness, lower);
}

TEST(Rules, ProfileIsThatOfSide) {
  const auto differs = [](const std::string& profile) {
    std::vector<std::string> told;
    for (const std::string& remark : remarks_of(two_soils(profile)))
      if (remark.find("the layers differ from the regions") != std::string::npos)
        told.push_back(remark);
    return told;
  };
  EXPECT_THAT(differs(layers("sand", 5.0, "stiff")), IsEmpty());
  // Half a particle is not seen: particles are 0.5 m wide.
  EXPECT_THAT(differs(layers("sand", 5.2, "stiff")), IsEmpty());
  EXPECT_THAT(
      differs(layers("sand", 4.0, "stiff")),
      ElementsAre(
          HasSubstr("at the left side: from 4 to 5 m depth (y = -4 to -5 m) the free field has 'stiff', "
                    "the domain 'sand'"),
          HasSubstr("at the right side")));
  const auto upside_down = differs(layers("stiff", 5.0, "sand"));
  ASSERT_EQ(upside_down.size(), 2U);
  EXPECT_THAT(upside_down[0], AllOf(HasSubstr("from 0 to 5 m depth"), HasSubstr("from 5 to 10 m depth")));
  // A profile that ends early stands on the half-space of the case, which is another ground.
  EXPECT_THAT(differs("[[profile]]\nthickness = 5.0\nsoil = \"sand\"\n"),
              ElementsAre(HasSubstr("the free field has elastic ground of 95.87 m/s, the domain 'stiff'"),
                          HasSubstr("right side")));
  // Layers of their own with the constants of the soil are the same ground.
  EXPECT_THAT(
      differs("[[profile]]\nthickness = 5.0\ndensity = 1700.0\nyoung = 40e6\npoisson = 0.28\n[[profile]]\n"
              "thickness = 5.0\ndensity = 1900.0\nyoung = 160e6\npoisson = 0.28\n"),
      IsEmpty());
}

TEST(Plan, HoldsTheLayersOfTheFreeFields) {
  const Case scene = parse_case(two_soils(layers("sand", 4.0, "stiff")));
  const auto field = nlohmann::json::parse(to_json(scene, plan(scene)))["free_field"];
  for (const char* side : {"left", "right"}) {
    ASSERT_EQ(field[side].size(), 2U);
    EXPECT_EQ(field[side][0], (nlohmann::json{{"top_m", 0.0}, {"bottom_m", -4.0}, {"soil", "sand"}}));
    EXPECT_EQ(field[side][1], (nlohmann::json{{"top_m", -4.0}, {"bottom_m", -10.0}, {"soil", "stiff"}}));
  }
}

} // namespace
} // namespace tremolo::scene::testing
