#include "mpm_domain/gravity/gravity_stage.hpp"

#include "mpm_domain/gravity/static_stages.hpp"
#include "mpm_domain/transfer/gather.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

Reactions bring_to_rest(Domain& domain, const GravitySettings& settings, std::span<const StaticStage> then,
                        const StageProgress& progress) {
  StaticStages stages(domain, settings, then, progress);
  while (!stages.are_over())
    stages.next();
  return stages.finish();
}

Reactions relax_under_gravity(Domain& domain, const GravitySettings& settings,
                              const GravityProgress& progress) {
  return bring_to_rest(domain, settings, {},
                       [&](std::size_t, long step, double residual) { progress(step, residual); });
}

void take_velocities_of_nodes(Domain& domain) {
  for (Particles& set : domain.sets) {
    std::ranges::fill(set.vx, 0.0);
    std::ranges::fill(set.vy, 0.0);
  }
  for (const auto& [begin, end] : domain.soil_rows)
    for (NodeField* before :
         {&domain.grid.vx_before, &domain.grid.vy_before}) // FLIP adds what nodes have gained
      std::fill(before->data() + begin, before->data() + end, 0.0);
  gather(domain, 0.0, {.velocity = true});
}

} // namespace tremolo::mpm_domain
