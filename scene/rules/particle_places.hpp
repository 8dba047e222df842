#pragma once

#include "scene/case.hpp"

#include "mesh/quadtree.hpp"

#include <functional>

namespace tremolo::scene {

/// Visits the places where the domain would put particles if soil filled all leaves that overlap a box, until
/// `found` says so. Only cells of the box are looked at: a mesh may have 1e9 particles.
/// @returns whether it was found
bool find_particle_place(const Case& scene, const mesh::Quadtree& tree, const mesh::Rectangle& box,
                         const std::function<bool(Point)>& found);

} // namespace tremolo::scene
