#pragma once

#include "coupler/participant.hpp"
#include "scene/plan/plan.hpp"

namespace tremolo::mpm_domain {

/// Serves the free field of a source by a periodic column of the case's own cells, particles and time step,
/// until the run ends.
/// @throws std::invalid_argument for layers that the column cannot have, coupler::Error, motion::RecordError
void serve_column(const scene::Case& scene, const scene::Plan& plan, const scene::SourceProcess& source,
                  const coupler::ParticipantOptions& options);

} // namespace tremolo::mpm_domain
