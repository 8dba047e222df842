#include "mpm_domain/step/full_mass_matrix.hpp"

#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"

namespace tremolo::mpm_domain {

void FullMassMatrix::solve(Domain& domain) {
  vx_ = domain.grid.vx_new;
  vy_ = domain.grid.vy_new;
  constexpr double no_time = 0.0; // reading velocities takes none
  for (int j = 1; j < order_; ++j) {
    gather(domain, no_time, {.velocity = true});
    scatter(domain, ScatterPart::momentum);
    refine_velocities(domain, vx_, vy_);
  }
}

void FullMassMatrix::restore(Domain& domain) {
  domain.grid.vx_new.swap(vx_);
  domain.grid.vy_new.swap(vy_);
}

} // namespace tremolo::mpm_domain
