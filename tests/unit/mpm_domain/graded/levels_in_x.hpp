#pragma once

// A block on a mesh that gets finer in x, for particles that are cut.

#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace tremolo::mpm_domain::test {

/// 1 m cells; half-metre cells for x > 6 m, quarter-metre ones for x > 9 m. The block lies in the coarse
/// ones.
inline Spec levels_in_x(Transfer transfer, int per_cell = 2) {
  Spec spec = test_support::elastic_box(12.0, 8.0, 1.0);
  spec.particles_per_cell = per_cell;
  spec.refine = {{{6.0, -8.0, 12.0, 0.0}, 1}, {{9.0, -8.0, 12.0, 0.0}, 2}};
  spec.regions = {{0, {{1.0, -6.0}, {4.0, -6.0}, {4.0, -3.0}, {1.0, -3.0}}}};
  spec.scheme.transfer = transfer;
  spec.threads = 1;
  return spec;
}

inline void shift(Domain& domain, double way) {
  for (Particles& p : domain.sets)
    for (double& x : p.x)
      x += way;
}

/// Random velocities and stresses, and boxes, where they follow the soil.
inline void disturb(Domain& domain) {
  std::mt19937 random(3);
  std::normal_distribution<double> any;
  for (Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      for (std::vector<double>* column : {&p.vx, &p.vy, &p.sxx, &p.syy, &p.szz, &p.sxy})
        (*column)[k] = any(random);
      if (p.traits.affine)
        for (std::vector<double>* column : {&p.bxx, &p.bxy, &p.byx, &p.byy})
          (*column)[k] = 0.1 * any(random);
      if (p.has_own_boxes())
        for (std::vector<double>* moment : {&p.box_xx, &p.box_yy})
          (*moment)[k] *= std::exp(0.3 * any(random));
    }
}

struct Conserved {
  double mass = 0.0, volume = 0.0, px = 0.0, py = 0.0, spin = 0.0, kinetic = 0.0;
};

inline Conserved conserved_by(const Domain& domain) {
  Conserved sum;
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double m = p.mass[k];
      sum.mass += m;
      sum.volume += p.volume[k];
      sum.px += m * p.vx[k];
      sum.py += m * p.vy[k];
      sum.spin += m * (p.x[k] * p.vy[k] - p.y[k] * p.vx[k]);
      if (p.traits.affine)
        sum.spin += m * (p.byx[k] - p.bxy[k]);
      sum.kinetic += 0.5 * m * (p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k]);
    }
  return sum;
}

/// Particles that change(domain) cuts bring to the nodes what they did before.
template <typename Change>
void expect_grid_as_it_was(Domain& domain, const Change& change) {
  sort_particles(domain);
  scatter(domain, ScatterPart::both);
  const Grid before = domain.grid;
  constexpr double largest = 1.7e4; // kg/m, N/m

  change(domain);
  sort_particles(domain);
  scatter(domain, ScatterPart::both);
  for (const NodeField Grid::*field :
       {&Grid::mass, &Grid::momentum_x, &Grid::momentum_y, &Grid::force_x, &Grid::force_y})
    for (std::size_t n = 0; n < before.size(); ++n)
      EXPECT_NEAR((domain.grid.*field)[n], (before.*field)[n], 1e-14 * largest);
}

} // namespace tremolo::mpm_domain::test
