#pragma once

// An elastic body that floats above the ground without weight, pulled by forces of the test and brought to
// rest by damping.

#include "tests/support/structure_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain::test {

/// A force on the body at a place.
struct PlacedForce {
  Vector position; ///< m
  Vector force;    ///< N/m
};

inline Spec floating(Structure body, const Stiffness& stiffness, std::vector<CutLine> cuts, double h) {
  Spec spec = test_support::flat_ground(12.0, 2.0, h, {2000.0, 2e8, 0.2});
  spec.gravity = 0.0;
  body.stiffness = stiffness;
  spec.structures = {std::move(body)};
  spec.sections = {{"cut", "block", std::move(cuts)}};
  return spec;
}

/// Spreads forces over the nodes of the body's lattice by their hat functions, as tractions are.
inline void add_forces(Domain& domain, std::span<const PlacedForce> forces) {
  const Lattice& lattice = domain.bodies.front().lattice;
  for (const auto& [position, force] : forces) {
    const double column = (position.x - lattice.x0) / lattice.h;
    const double row = (position.y - lattice.y0) / lattice.h;
    const int i = static_cast<int>(std::floor(column));
    const int j = static_cast<int>(std::floor(row));
    for (const int up : {0, 1})
      for (const int right : {0, 1}) {
        const double share =
            (right == 1 ? column - i : 1.0 - column + i) * (up == 1 ? row - j : 1.0 - row + j);
        const std::size_t node = lattice.index(i + right, j + up);
        domain.grid.force_x[node] += share * force.x;
        domain.grid.force_y[node] += share * force.y;
      }
  }
}

/// Lets forces act on the body until it rests.
/// @param omega     of the slowest motion, 1/s, which is damped critically
/// @param duration  s
inline void pull_to_rest(Domain& domain, std::vector<PlacedForce> forces, double omega, double duration) {
  // Free fields come in when particles have brought their forces to the nodes, which have not moved yet.
  Stepper stepper(domain, 0.0, [&](long, double, std::span<const Vector>, std::span<eq6::FreeField> field) {
    std::ranges::fill(field, eq6::FreeField{});
    add_forces(domain, forces);
  });
  while (stepper.time() < duration) {
    stepper.step();
    const double keep = 1.0 - 2.0 * omega * stepper.kick();
    for (Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        for (double* value : {&set.vx[k], &set.vy[k], &set.bxx[k], &set.bxy[k], &set.byx[k], &set.byy[k]})
          *value *= keep;
  }
}

/// Cuts through a ring from inside outwards.
inline std::vector<CutLine> cuts_around(const Vector& centre, double inner, double outer,
                                        std::span<const double> degrees) {
  std::vector<CutLine> cuts;
  for (const double angle : degrees) {
    const Vector out{std::cos(angle * std::numbers::pi / 180.0), std::sin(angle * std::numbers::pi / 180.0)};
    cuts.push_back({{centre.x + inner * out.x, centre.y + inner * out.y},
                    {centre.x + outer * out.x, centre.y + outer * out.y}});
  }
  return cuts;
}

} // namespace tremolo::mpm_domain::test
