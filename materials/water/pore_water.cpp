#include "materials/water/pore_water.hpp"

#include "materials/law/parameter_check.hpp"

#include <cmath>
#include <limits>

namespace tremolo::materials {
namespace {

/// Isotropic constants of a bulk and a shear modulus, Pa.
Elasticity from_moduli(double density, double bulk, double shear, double rest_coefficient) {
  return {.density = density,
          .young = 9.0 * bulk * shear / (3.0 * bulk + shear),
          .poisson = (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear)),
          .at_rest = rest_coefficient};
}

} // namespace

double dry_density(const PoreSpace& pores) {
  return (1.0 - pores.porosity) * pores.grain_density;
}

double saturated_density(const PoreSpace& pores, const PoreFluid& water) {
  return dry_density(pores) + pores.porosity * water.density;
}

double buoyant_density(const PoreSpace& pores, const PoreFluid& water) {
  return saturated_density(pores, water) - water.density;
}

double pore_stiffness(const PoreSpace& pores, const PoreFluid& water) {
  return water.bulk_modulus / pores.porosity;
}

Elasticity dry(const Elasticity& skeleton, const PoreSpace& pores) {
  Elasticity soil = skeleton;
  soil.density = dry_density(pores);
  return soil;
}

Elasticity saturated(const Elasticity& skeleton, const PoreSpace& pores, const PoreFluid& water) {
  const double density = saturated_density(pores, water);
  if (pores.drainage != Drainage::drained)
    return from_moduli(density, skeleton.bulk_modulus() + pore_stiffness(pores, water),
                       skeleton.shear_modulus(), skeleton.rest_coefficient());
  Elasticity soil = skeleton;
  soil.density = density;
  return soil;
}

SaturatedSpeeds saturated_speeds(double p_modulus, const PoreSpace& pores, const PoreFluid& water) {
  const double n = pores.porosity;
  const double q = pore_stiffness(pores, water);
  const double solid = dry_density(pores);
  const double fluid = n * water.density;
  const double ss = (p_modulus + q * (1.0 - n) * (1.0 - n)) / solid;
  const double ff = q * n * n / fluid;
  const double product = q * n * (1.0 - n);
  // The smaller root from the determinant M Q n^2/(m_s m_f): no difference of large numbers.
  const double middle = 0.5 * (ss + ff);
  const double fast = middle + std::hypot(0.5 * (ss - ff), product / std::sqrt(solid * fluid));
  const double determinant = p_modulus * q * n * n / (solid * fluid);
  return {std::sqrt(fast), std::sqrt(determinant / fast),
          std::sqrt((p_modulus + q) / saturated_density(pores, water))};
}

double flow_resistance(const PoreSpace& pores, const PoreFluid& water, double gravity) {
  return water.density * gravity / pores.permeability;
}

double drag_rate(const PoreSpace& pores, const PoreFluid& water, double gravity) {
  return pores.porosity * gravity * saturated_density(pores, water) /
         (pores.permeability * dry_density(pores));
}

double consolidation_coefficient(double p_modulus, const PoreSpace& pores, const PoreFluid& water,
                                 double gravity) {
  return 1.0 /
         (flow_resistance(pores, water, gravity) * (1.0 / p_modulus + 1.0 / pore_stiffness(pores, water)));
}

void validate(const PoreFluid& water) {
  check_positive("density of water", water.density);
  check_positive("bulk modulus of water", water.bulk_modulus);
  check_range("cavitation pressure of water", water.cavitation_pressure,
              std::numeric_limits<double>::lowest(), 0.0);
}

void validate(const PoreSpace& pores) {
  check_range("porosity", pores.porosity, 0.01, 0.95);
  check_positive("grain density", pores.grain_density);
  if (pores.drainage == Drainage::coupled)
    check_positive("permeability", pores.permeability);
}

} // namespace tremolo::materials
