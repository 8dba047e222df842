#include "mpm_domain/process/checkpoints.hpp"

#include "mpm_domain/state.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>

namespace tremolo::mpm_domain {

bool Checkpoints::due(long step) const {
  if (wanted_.keep == 0)
    return false;
  if (wanted_.every_steps)
    return step % *wanted_.every_steps == 0;
  return coupler::seconds_since(last_) >= wanted_.every_wall;
}

void Checkpoints::save(coupler::DomainClient& client, Domain& domain, std::span<const Particles> sets,
                       const Stepper& stepper, RunOutput& output) {
  try {
    client.checkpoint(stepper.time(), [&](results::CheckpointWriter& file) {
      output.save(file);
      domain.boundary.save_rest(file);
      mpm_domain::save(domain, sets, file);
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
