// The critical step 2/omega_max of M^-1 K, by power iteration through the domain's own passes: hanging and
// virtual nodes must not shorten it below that of a uniform mesh of the finest cells.

#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/elastic_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tremolo::mpm_domain {
namespace {

/// 2/omega_max over h_fine/c_p of a free block.
double critical_step(Domain& domain) {
  Grid& grid = domain.grid;
  scatter(domain, ScatterPart::motion);
  const double empty = empty_mass(domain);
  const std::size_t nodes = grid.size();
  for (std::size_t n = 0; n < nodes; ++n) {
    const bool full = grid.mass[n] > empty;
    grid.vx_after[n] = full ? std::sin(12.9898 * static_cast<double>(n)) : 0.0;
    grid.vy_after[n] = full ? std::cos(78.233 * static_cast<double>(n)) : 0.0;
  }
  double eigenvalue = 0.0;
  for (int iteration = 0; iteration < 3000; ++iteration) {
    double before = 0.0;
    for (std::size_t n = 0; n < nodes; ++n)
      before += grid.mass[n] * (grid.vx_after[n] * grid.vx_after[n] + grid.vy_after[n] * grid.vy_after[n]);
    const double scale = 1e-6 / std::sqrt(before); // strains so small that volumes stay as they are
    for (std::size_t n = 0; n < nodes; ++n) {
      grid.vx_after[n] *= scale;
      grid.vy_after[n] *= scale;
    }
    test_support::elastic_forces(domain);
    double power = 0.0;
    for (std::size_t n = 0; n < nodes; ++n) {
      if (grid.mass[n] <= empty)
        continue;
      power -= grid.force_x[n] * grid.vx_after[n] + grid.force_y[n] * grid.vy_after[n];
      grid.vx_after[n] = -grid.force_x[n] / grid.mass[n];
      grid.vy_after[n] = -grid.force_y[n] / grid.mass[n];
    }
    eigenvalue = power * 1e12; // over v^T M v = 1e-12
  }
  const double c = materials::elasticity(domain.spec.soils.front().law).p_wave_speed();
  return 2.0 / std::sqrt(eigenvalue) * c / domain.finest_lattice().h;
}

/// A block whose fine cells have outer and re-entrant corners and reach its surface.
Spec graded(double shift) {
  Spec spec = test_support::elastic_box(8.0, 8.0, 1.0);
  spec.threads = 1;
  spec.refine = {{{2.0, -6.0, 6.0, -4.0}, 1}, {{2.0, -4.0, 4.0, 0.0}, 1}, {{3.0, -5.0, 4.0, -3.0}, 2}};
  for (Vector& corner : spec.regions.front().polygon) {
    corner.x = 1.0 + 0.75 * corner.x + shift;
    corner.y = -1.0 + 0.75 * corner.y;
  }
  return spec;
}

TEST(CriticalStep, HangingNodesCostNothing) {
  Spec uniform = test_support::elastic_box(2.0, 2.0, 0.25);
  uniform.threads = 1;
  Domain fine(uniform);
  const double reference = critical_step(fine);
  EXPECT_GT(reference, 0.7); // of a free corner, which rules
  for (const double shift : {0.0, 0.25}) {
    Domain domain(graded(shift));
    EXPECT_GT(critical_step(domain), 0.99 * reference) << shift;
  }
}

/// Wherever the particles have gone in their cells, the step that is taken stays below the critical one.
TEST(CriticalStep, IsAboveTheOneTakenForParticlesOutOfPlace) {
  for (const double move : {0.03, 0.11, 0.19, 0.37}) {
    Domain domain(graded(0.0));
    for (Particles& p : domain.sets)
      for (std::size_t k = 0; k < p.size(); ++k) {
        p.x[k] += move;
        p.y[k] += 0.7 * move;
      }
    sort_particles(domain);
    EXPECT_GT(critical_step(domain), 0.65 * 1.0) << move;
  }
}

} // namespace
} // namespace tremolo::mpm_domain
