#pragma once

// A strip footing on clay, whose load is the weight of a block as wide: stiff and bonded to the clay, a rough
// rigid footing, or soft as a liquid in shear, a uniform pressure. On clay of one strength it carries
// (2 + pi) c (Prandtl), rough or smooth, whatever Poisson's ratio.

#include "tests/verification/mpm_domain/limit_loads/static_limit.hpp"

#include <numbers>
#include <ostream>

namespace tremolo::mpm_domain::test {

inline constexpr double footing_width = 4.0; // m
inline constexpr double clay_depth = 4.0;    // m

/// Clay that carries a rough footing comes to rest within 4 s, under a smooth one within 10 s.
inline constexpr double rough_patience = 8.0; // s

/// The weight of clay without friction is no help to a footing on it.
inline materials::MohrCoulomb light_clay(double poisson, double cohesion) {
  return perfectly_plastic({500.0, 20e6, poisson}, cohesion, 0.0);
}

/// Clay to both sides and below, soil 0 of region 0, and the block, soil 1 of region 1.
/// @param pressure   of the block's weight, Pa
/// @param stiffness  Young's modulus of the block, Pa
inline Spec footing_on_clay(double cell_size, double pressure, double stiffness) {
  constexpr double side = 6.0, block = 1.0; // m
  constexpr double right = 2.0 * side + footing_width;
  Spec spec;
  spec.box = {0.0, -clay_depth, right, block};
  spec.cell_size = cell_size;
  spec.gravity = gravity;
  spec.soils = {{"clay", light_clay(0.3, 20e3)},
                {"block", materials::LinearElastic{{pressure / (gravity * block), stiffness, 0.0}}}};
  spec.regions = {
      {0, {{0.0, -clay_depth}, {right, -clay_depth}, {right, 0.0}, {0.0, 0.0}}},
      {1, {{side, 0.0}, {side + footing_width, 0.0}, {side + footing_width, block}, {side, block}}}};
  return spec;
}

struct Footing {
  bool rough;
  double cell_size; ///< m
  double poisson;   ///< of the clay

  friend void PrintTo(const Footing& f, std::ostream* out) {
    *out << (f.rough ? "rough" : "smooth") << ", cells of " << f.cell_size << " m, nu " << f.poisson;
  }
};

/// @param load  over (2 + pi) c
inline bool stands(const Footing& footing, double load) {
  constexpr double cohesion = 20e3; // Pa
  Spec spec = footing_on_clay(footing.cell_size, load * (2.0 + std::numbers::pi) * cohesion,
                              footing.rough ? 2e8 : 2e5);
  spec.soils.front().law = light_clay(footing.poisson, cohesion);
  return carries_its_weight(spec, footing.rough ? rough_patience : 15.0);
}

} // namespace tremolo::mpm_domain::test
