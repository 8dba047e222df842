#pragma once

// The static stages of a run: the domain comes to rest before it is shaken, and leaves frames of the stages
// where there are several. A run may end after any of them. What it goes on from is then its checkpoint of
// step 0, which holds the state of the static stages (gravity/static_stages.hpp) in the place of that of the
// shaking.

#include "coupler/participant.hpp"
#include "mpm_domain/domain.hpp"
#include "results/checkpoint_file.hpp"
#include "scene/case.hpp"
#include "scene/plan/plan.hpp"

#include <cstddef>
#include <string>

namespace tremolo::mpm_domain {

/// A process's view of the run.
struct RunOfCase {
  const scene::Case& scene;
  const scene::Plan& plan;
  const coupler::ParticipantOptions& options;
  coupler::DomainClient* client; ///< null on all ranks but the first
  Communicator* ranks;           ///< null where there is one process
};

/// Why a run has ended that was asked to end after a stage.
std::string ended_after(const std::string& stage);

/// Number of static stages of a case, including gravity.
std::size_t static_stage_count(const scene::Case& scene);

/// Whether a checkpoint was made before the static stages were over.
bool is_before_shaking(const scene::Case& scene, const results::CheckpointReader& saved);

struct AtRest {
  double seconds = 0.0; ///< wall time that it took
  bool ended = false;   ///< the run has ended after a static stage that is not the last one
};

/// Brings the domain to rest. All ranks that share it call it.
/// @param saved  state of the static stages to go on from; null: none
/// @param until  name of the stage that the run ends after; empty: the last one
/// @throws std::runtime_error where the ground finds no rest; a frame then shows where it moves
AtRest come_to_rest(Domain& domain, const RunOfCase& run, const results::CheckpointReader* saved,
                    const std::string& until);

} // namespace tremolo::mpm_domain
