#pragma once

#include "scene/plan/plan.hpp"

namespace tremolo::scene {

/// Bytes of run.h5 and run.xdmf at most, without what compression saves.
/// @param plan  with its levels, particles, structures and frames
double output_bytes(const Case& scene, const Plan& plan);

} // namespace tremolo::scene
