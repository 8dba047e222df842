#pragma once

#include "scene/plan/plan.hpp"

#include <cstddef>

namespace tremolo::scene {

/// Bytes of run.h5 and run.xdmf at most, without what compression saves.
/// @param plan  with its levels, particles, structures and frames
double output_bytes(const Case& scene, const Plan& plan);

/// Faces of the boundary, a particle long each, as many at most as if each edge had its finest cells all
/// along.
std::size_t most_faces(const Case& scene);

} // namespace tremolo::scene
