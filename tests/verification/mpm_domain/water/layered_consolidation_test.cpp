// Consolidation of a tight layer over a permeable one half as stiff, against the eigenfunctions of both: the
// flux and the pressure are continuous where permeability, porosity and stiffness jump.

#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "tests/support/two_layer_consolidation.hpp"
#include "tests/verification/mpm_domain/water/saturated_column.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace tremolo::mpm_domain {
namespace {

constexpr double cell = 0.1; // m
constexpr materials::PoreFluid fluid{.bulk_modulus = 2.2e8};

struct Layer {
  double thickness, modulus, permeability, porosity; // m, Pa, m/s, 1

  Soil soil() const {
    Soil soil{.name = "layer"};
    soil.pores = {.porosity = porosity, .grain_density = 2650.0, .permeability = permeability};
    soil.law = materials::LinearElastic{{materials::saturated_density(*soil.pores, fluid), modulus, 0.0}};
    return soil;
  }
  /// c_v, m2/s
  double diffusivity() const {
    return materials::consolidation_coefficient(modulus, *soil().pores, fluid, 9.81);
  }
};

/// @param times  s
void expect_eigenfunctions(std::initializer_list<double> times) {
  constexpr Layer upper{1.0, 2e7, 1e-4, 0.4};
  constexpr Layer lower{2.0, 1e7, 1e-3, 0.45};
  constexpr double depth = upper.thickness + lower.thickness;
  Spec spec;
  spec.box = {0.0, -depth, cell, 0.0};
  spec.cell_size = cell;
  spec.gravity = 9.81;
  spec.sides = Sides::periodic;
  spec.scheme.fraction = 0.9;
  spec.water = {0.0, fluid};
  spec.soils = {upper.soil(), lower.soil()};
  spec.regions = {{1, {{0.0, -depth}, {cell, -depth}, {cell, 0.0}, {0.0, 0.0}}},
                  {0, {{0.0, -upper.thickness}, {cell, -upper.thickness}, {cell, 0.0}, {0.0, 0.0}}}};
  Domain domain(spec);
  replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
  constexpr double load = 1e4; // Pa
  test_support::load_water(domain, [](double) { return load; });
  Stepper stepper(domain, 0.0, test_support::at_rest_source());
  const test_support::TwoLayers exact(upper.thickness, upper.diffusivity(), upper.permeability,
                                      lower.thickness, lower.diffusivity(), lower.permeability);
  for (const double time : times) {
    while (stepper.time() < time)
      stepper.step();
    double squares = 0.0;
    int count = 0;
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k, ++count) {
        const double centre = (std::floor(set.y_initial[k] / cell) + 0.5) * cell;
        const double error = excess_pressure(set, k) / load - exact.pressure(-centre, stepper.time());
        squares += error * error;
      }
    EXPECT_LT(std::sqrt(squares / count), 2e-3) << time << " s";
  }
}

TEST(LayeredConsolidation, FollowsTheEigenfunctionsOfTwoLayers) {
  expect_eigenfunctions({0.5, 2.0});
}

TEST(AcceptanceLayeredConsolidation, FollowsTheEigenfunctionsToTheEnd) {
  expect_eigenfunctions({0.5, 2.0, 6.0});
}

} // namespace
} // namespace tremolo::mpm_domain
