// Saturated soil: densities, undrained constants, speeds of waves and drag against values worked out by hand
// or from the dispersion relation.

#include "materials/water/pore_water.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace tremolo::materials {
namespace {

constexpr PoreFluid water;
constexpr PoreSpace sand{.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-4};

TEST(PoreWater, DensitiesFollowFromGrainsAndPorosity) {
  EXPECT_DOUBLE_EQ(saturated_density(sand, water), 1990.0);
  EXPECT_DOUBLE_EQ(dry_density(sand), 1590.0);
  EXPECT_DOUBLE_EQ(buoyant_density(sand, water), 990.0);
  EXPECT_DOUBLE_EQ(sand.void_ratio(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(porosity_of(sand.void_ratio()), 0.4);
}

TEST(PoreWater, UndrainedSoilHasTheShearModulusOfTheSkeletonAndTheBulkModulusOfBoth) {
  const Elasticity skeleton{.density = 1990.0, .young = 40e6, .poisson = 0.3};
  const Elasticity soil = saturated(skeleton, sand, water);
  EXPECT_NEAR(soil.shear_modulus(), skeleton.shear_modulus(), 1e-9 * skeleton.shear_modulus());
  EXPECT_NEAR(soil.bulk_modulus(), skeleton.bulk_modulus() + 5.5e9, 1e-6 * 5.5e9);
  EXPECT_EQ(soil.density, 1990.0);
  EXPECT_DOUBLE_EQ(soil.rest_coefficient(), 0.3 / 0.7);
  EXPECT_NEAR(soil.p_wave_speed(), saturated_speeds(skeleton.p_modulus(), sand, water).undrained, 1e-3);

  PoreSpace gravel = sand;
  gravel.drainage = Drainage::drained;
  EXPECT_EQ(saturated(skeleton, gravel, water).young, skeleton.young);
  EXPECT_EQ(dry(skeleton, sand).density, 1590.0);
}

/// Roots of the determinant |K - c^2 R| without drag, computed apart to the figures that are shown.
TEST(PoreWater, SpeedsWithoutDragAreTheRootsOfTheDispersionRelation) {
  struct Row {
    double modulus, fast, slow, undrained;
  };
  for (const auto& [modulus, fast, slow, undrained] :
       {Row{2e7, 1857.0, 90.0, 1665.0}, Row{1e8, 1862.0, 200.0, 1678.0}, Row{5e8, 1888.0, 440.0, 1736.0}}) {
    const auto speeds = saturated_speeds(modulus, sand, water);
    EXPECT_NEAR(speeds.fast, fast, 1.0);
    EXPECT_NEAR(speeds.slow, slow, 1.0);
    EXPECT_NEAR(speeds.undrained, undrained, 1.0);
    for (const double c2 : {speeds.fast * speeds.fast, speeds.slow * speeds.slow}) {
      const double q = 5.5e9, n = 0.4, ms = 1590.0, mf = 400.0;
      const double a = modulus + q * (1.0 - n) * (1.0 - n) - c2 * ms;
      const double b = q * n * n - c2 * mf;
      const double d = q * n * (1.0 - n);
      EXPECT_NEAR(a * b / (d * d), 1.0, 1e-9);
    }
  }
}

TEST(PoreWater, DragTakesTheRelativeVelocityAtItsRate) {
  // n g rho/(k (1 - n) rho_s) = 0.4 * 9.81 * 1990/(1e-4 * 1590)
  EXPECT_NEAR(drag_rate(sand, water, 9.81), 49111.7, 0.1);
  EXPECT_DOUBLE_EQ(flow_resistance(sand, water, 9.81), 9.81e7);
  // Skeleton of 1e7 Pa: water of 5.5e9 Pa takes 0.18 % off k M/(rho_f g).
  EXPECT_NEAR(consolidation_coefficient(1e7, sand, water, 9.81), 0.101937 / (1.0 + 1e7 / 5.5e9), 1e-6);
}

TEST(PoreWater, ValuesOutOfRangeAreRefused) {
  EXPECT_THROW(validate(PoreFluid{.density = 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(PoreFluid{.cavitation_pressure = 1.0}), std::invalid_argument);
  EXPECT_THROW(validate(PoreSpace{.porosity = 1.2, .grain_density = 2650.0, .permeability = 1e-4}),
               std::invalid_argument);
  EXPECT_THROW(validate(PoreSpace{.porosity = 0.4, .grain_density = 2650.0}), std::invalid_argument);
  EXPECT_NO_THROW(
      validate(PoreSpace{.porosity = 0.4, .grain_density = 2650.0, .drainage = Drainage::undrained}));
}

} // namespace
} // namespace tremolo::materials
