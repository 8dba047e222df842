#pragma once

// Models whose factor of safety is known.
//
// Sand and c-phi soil. Bishop's simplified method with toe circles, by a search of its own (1955,
// Geotechnique 5(1), 7-17), gives the factors of slopes of 2 to 1 and 3 to 1, dry and under free water, which
// weighs on the slope as it weighs on level ground: soil of the submerged slope has its weight under water.
// In sand without cohesion the skin of a slope of angle beta slides first, F = tan(phi)/tan(beta).
//
// Clay of the strength s_u. A vertical cut of height H stands where gamma H is below N s_u; limit analysis
// has N between 3.7752 and 3.7776 (Kammoun, Pastor, Smaoui and Pastor 2010, Int. J. Numer. Anal. Meth.
// Geomech., doi 10.1002/nag.887), circles give 3.83 (Taylor 1948). A strip load fails at (2 + pi) s_u
// (Prandtl).

#include "tests/verification/mpm_domain/limit_loads/footing.hpp"
#include "tests/verification/mpm_domain/limit_loads/slope.hpp"

#include <numbers>
#include <ostream>
#include <string>

namespace tremolo::mpm_domain::test {

/// A slope on a layer of half its height.
struct BishopSlope {
  double run; ///< horizontal length over height
  double friction_deg;
  double cohesion;    ///< over gamma H
  double unit_weight; ///< gamma, saturated, N/m3
  bool submerged;
  double cell_size; ///< m
  double factor;

  friend void PrintTo(const BishopSlope& s, std::ostream* out) {
    *out << s.run << " to 1, phi " << s.friction_deg << " deg, c/(gamma H) " << s.cohesion
         << (s.submerged ? ", submerged" : ", dry") << ", cells of " << s.cell_size << " m";
  }
};

inline Spec spec_of(const BishopSlope& of) {
  constexpr materials::PoreFluid water{};
  constexpr double porosity = 0.4;
  const double density = of.unit_weight / gravity;
  Spec spec = spec_of({std::atan(1.0 / of.run) / degree, 1.5, of.cell_size},
                      perfectly_plastic({density, 100e6, 0.3}, of.cohesion * of.unit_weight * height,
                                        of.friction_deg * degree));
  if (of.submerged) {
    spec.water = {height + 2.0, water};
    spec.soils.front().pores = {.porosity = porosity,
                                .grain_density = (density - porosity * water.density) / (1.0 - porosity),
                                .drainage = materials::Drainage::drained};
  }
  return spec;
}

/// A vertical cut in clay on a layer of half its height.
/// @param factor  by which its strength exceeds what it needs
inline Spec vertical_cut(double cell_size, double factor) {
  constexpr double density = 1800.0;
  constexpr double number = 3.7764;
  Spec spec;
  spec.box = {0.0, -0.5 * height, 3.0 * height, height};
  spec.cell_size = cell_size;
  spec.gravity = gravity;
  spec.soils = {{"clay", materials::multi_yield_clay({density, 50e6, 0.3},
                                                     factor * density * gravity * height / number)}};
  spec.regions = {{0,
                   {{0.0, -0.5 * height},
                    {3.0 * height, -0.5 * height},
                    {3.0 * height, height},
                    {1.2 * height, height},
                    {1.2 * height, 0.0},
                    {0.0, 0.0}}}};
  return spec;
}

/// A strip load on level clay.
/// @param factor  by which its strength exceeds what Prandtl's load needs
inline Spec strip_load(double cell_size, double factor) {
  constexpr double side = 6.0, pressure = 100e3; // m, Pa
  constexpr double right = 2.0 * side + footing_width;
  Spec spec;
  spec.box = {0.0, -clay_depth, right, 0.0};
  spec.cell_size = cell_size;
  spec.gravity = gravity;
  spec.soils = {{"clay", materials::multi_yield_clay({1800.0, 50e6, 0.3},
                                                     factor * pressure / (2.0 + std::numbers::pi))}};
  spec.regions = {{0, {{0.0, -clay_depth}, {right, -clay_depth}, {right, 0.0}, {0.0, 0.0}}}};
  spec.loads = {{side, side + footing_width, pressure, 0.0}};
  return spec;
}

inline constexpr double sand_friction_deg = 33.0; // phi_cv of PM4Sand
inline constexpr double sand_slope_deg = 20.0;
inline double sand_factor() {
  return std::tan(sand_friction_deg * degree) / std::tan(sand_slope_deg * degree);
}

/// Sand without cohesion, whose surface in cells is a stair.
inline Spec sand_slope(double cell_size) {
  return spec_of(
      {sand_slope_deg, 1.5, cell_size},
      materials::pm4sand({.density = 1700.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.4}));
}

/// A ridge of two slopes: 45 degrees of weak soil on the left, and on the right the slope of 2 to 1 of
/// Bishop.
inline Spec ridge(double cell_size) {
  const BishopSlope right{2.0, 20.0, 0.05, 20e3, false, cell_size, 1.383};
  Spec spec = spec_of(right);
  materials::MohrCoulomb weak = perfectly_plastic({20e3 / gravity, 100e6, 0.3}, 12e3, 15.0 * degree);
  spec.box = {0.0, -5.0, 80.0, 10.0};
  spec.soils.push_back({"weak", weak});
  spec.regions = {{0, {{32.0, -5.0}, {80.0, -5.0}, {80.0, 0.0}, {66.0, 0.0}, {46.0, 10.0}, {32.0, 10.0}}},
                  {1, {{0.0, -5.0}, {32.0, -5.0}, {32.0, 10.0}, {22.0, 10.0}, {12.0, 0.0}, {0.0, 0.0}}}};
  return spec;
}

} // namespace tremolo::mpm_domain::test
