#pragma once

#include "mpm_domain/boundary_faces.hpp"
#include "mpm_domain/energy_ledger.hpp"
#include "mpm_domain/grid.hpp"
#include "mpm_domain/matched_layer.hpp"
#include "mpm_domain/particles.hpp"
#include "mpm_domain/spec.hpp"
#include "mpm_domain/worker_pool.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// The state of the two-dimensional plane-strain domain: particles, grid and boundary faces. What happens to
/// it in a step stands in the passes (scatter, grid_update, gather, ...), which the Stepper strings together.
struct Domain {
  /// Fills the regions with particles at rest and without stress.
  /// @throws std::invalid_argument for a spec that cannot be built
  explicit Domain(const Spec& specification);

  Spec spec;
  Grid grid;
  std::vector<Particles> sets; ///< one per soil
  std::vector<BoundaryFace> faces;
  std::vector<Vector> static_tractions; ///< f^st of Eq. (6), Pa, one per face
  std::vector<MatchedLayer> layers;     ///< see attach_matched_layers
  EnergyLedger energy;
  WorkerPool workers;

  double half_size() const; ///< l of a particle's box, m
  Axis x_axis() const { return {grid.x0, grid.h, half_size()}; }
  Axis y_axis() const { return {grid.y0, grid.h, half_size()}; }
  std::size_t particle_count() const;
  std::size_t block_count() const { return sets.front().block_start.size() - 1; }
  double fastest_wave(); ///< largest c_p of the particles in their present stress, m/s
};

/// A node with less mass (kg/m) is empty: rounding of weights, not soil.
double empty_mass(const Domain& domain);

/// The critical time step, s: 0.65 h / (c_p + |v|).
///
/// 0.746 h/c_p is what two-dimensional uGIMP with two particles a cell and direction allows inside; dashpots
/// at a corner, taken centred with lumped damping, allow 0.65 (measured; tests/stability/mpm_domain).
double critical_time_step(Domain& domain, double max_speed);

} // namespace tremolo::mpm_domain
