#pragma once

#include "scene/case.hpp"

#include "mesh/quadtree.hpp"

#include <functional>

namespace tremolo::scene {

/// A square that soil would fill with a particle.
struct ParticlePosition {
  Point middle;
  Point particle; ///< the centroid of what structures leave of it
};

/// Visits the positions where the domain would put particles if soil filled all leaves that overlap a box and
/// structures took what is theirs, until `found` says so. Only cells of the box are looked at: a mesh may
/// have 1e9 particles.
/// @returns whether it was found
bool find_particle_position(const Case& scene, const mesh::Quadtree& tree, const mesh::Rectangle& box,
                            const std::function<bool(const ParticlePosition&)>& found);

} // namespace tremolo::scene
