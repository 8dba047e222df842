#pragma once

#include "coupler/participant.hpp"
#include "mpm_domain/particles/all/all_particles.hpp"
#include "mpm_domain/process/output/run_output.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "results/checkpoint_file.hpp"
#include "scene/case.hpp"

#include <cstdio>

namespace tremolo::mpm_domain {

/// Makes the domain's part of checkpoints when the case wants them.
class Checkpoints {
public:
  explicit Checkpoints(const scene::Case& scene) : scene_(scene), last_(coupler::Clock::now()) {}

  /// Whether one is due after a step.
  [[nodiscard]] bool due(long step) const;

  /// Saves one. A disk that does not take it is a warning: the run goes on, and so does the last checkpoint.
  /// @param particles  of the domain; where ranks share it, those that rank 0 is shown
  void save(coupler::DomainClient& client, Domain& domain, const AllParticles& particles,
            const Stepper& stepper, RunOutput& output);

private:
  const scene::Case& scene_;
  coupler::Clock::time_point last_;
};

} // namespace tremolo::mpm_domain
