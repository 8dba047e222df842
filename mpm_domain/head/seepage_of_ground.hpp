#pragma once

// Steady flow through the ground of a model, before anything moves. Its mesh are the finest cells of the
// model, or cells twice as large, and so on, where these were more than some ten thousand; the nodes nearest
// to the surface of the ground stand on it, so that slopes up to 45 degrees are smooth and steeper ones have
// steps of a cell. Water enters and leaves through
//
//     both sides of the model up to the level there, and what lies above it is sealed,
//     the surface below free water, which reaches from a side to where the ground rises above its level,
//     the rest of the surface, where it can only leave.
//
// The base is sealed, and structures and linings are all but tight. The heads at the nodes of the regular
// grid follow from those of the mesh, by their slope there; outside of the ground they go on for one cell so,
// and are then those of free water, or of the nearest ground.

#include "mpm_domain/head/head.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <optional>

namespace tremolo::mpm_domain {

/// The flow in the numbers of interest to a user.
struct SeepageFound {
  double discharge = 0.0; ///< m2/s
  int iterations = 0;
  std::optional<Vector> exit; ///< where the phreatic surface comes out of the ground, m
  double steepest_rise = 0.0; ///< largest upward -dh/dy of wet ground, 1
  Vector at;                  ///< where that is, m
};

struct SeepageOfGround {
  Head head;
  SeepageFound found;
};

/// @param spec  with SideLevels of its water
/// @throws std::invalid_argument for levels that cannot be, or a soil without permeability, which it names
/// @throws seepage::NoSteadyFlow
SeepageOfGround seep(const Spec& spec);

/// The head of a spec's water; nothing without water.
/// @throws as seep()
std::optional<Head> head_of(const Spec& spec);

} // namespace tremolo::mpm_domain
