#include "mpm_domain/process/checkpoints.hpp"

#include "mpm_domain/gravity/static_stages.hpp"
#include "mpm_domain/process/come_to_rest.hpp"
#include "mpm_domain/state.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>

namespace tremolo::mpm_domain {

bool Checkpoints::due(long step) const {
  const scene::Checkpoints& wanted = scene_.checkpoints;
  if (wanted.keep == 0)
    return false;
  if (wanted.every_steps)
    return step % *wanted.every_steps == 0;
  return coupler::seconds_since(last_) >= wanted.every_wall;
}

void Checkpoints::save(coupler::DomainClient& client, Domain& domain, const AllParticles& particles,
                       const Stepper& stepper, RunOutput& output) {
  try {
    client.checkpoint(stepper.time(), [&](results::CheckpointWriter& file) {
      output.save(file);
      StaticStages::save_count(static_stage_count(scene_), file);
      domain.boundary.save_rest(file);
      mpm_domain::save(domain, particles, file);
      stepper.save(file);
    });
  } catch (const coupler::Aborted&) {
    throw; // not of the checkpoint, but of the run
  } catch (const std::runtime_error& error) {
    fmt::print("warning: no checkpoint at step {}: {}\n", stepper.steps(), error.what());
    std::fflush(stdout);
  }
  last_ = coupler::Clock::now();
}

} // namespace tremolo::mpm_domain
