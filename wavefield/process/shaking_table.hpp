#pragma once

#include "coupler/participant.hpp"
#include "scene/case.hpp"
#include "scene/plan/plan.hpp"

namespace tremolo::wavefield {

/// Serves the motion of a shaking table to a run: everywhere the velocity that the case gives, along x for SV
/// and along y for P and for [motion.vertical], and no stress.
/// @throws motion::RecordError for a record that cannot be read
void serve_shaking_table(const scene::Case& scene, const scene::SourceProcess& source,
                         const coupler::ParticipantOptions& options);

} // namespace tremolo::wavefield
