#pragma once

// A pass is a named part of a step. Each room that has work in a step gives its passes, with the phases that
// they belong to; the recipe (step/recipe.hpp) orders those of all rooms by phase. A pass of an effect that a
// scene does not call for is not there at all.

#include "mpm_domain/passes/step.hpp"

#include <functional>
#include <string>

namespace tremolo::mpm_domain {

/// The phases of a step, in their order. The first two come once a step, all others at each of its ticks
/// (clocks/ticks.hpp).
enum class Phase {
  step_length, ///< dt
  sort,        ///< particles by tile and cell, if they have moved far enough
  scatter,     ///< particles to grid: m, p, f of particles
  velocities,  ///< v- = p/m
  exchange,    ///< velocities of the faces go out, the free field comes in
  supports,    ///< the supports behind the faces move
  forces,      ///< of the boundary
  update,      ///< v+ from v- and f
  contact,     ///< impulses between soil and structures change v+
  books,       ///< work of the forces on v- and v+, which are final now
  gather,      ///< v+ to particles and, for musl, their new momenta back to the grid
  remap,       ///< u, the velocity that strains the soil (musl)
  pressure,    ///< pore pressures from u
  stress,      ///< particles move; strain and stress from u
  bodies,      ///< structures move
  settle,      ///< what is left for output, and totals over ranks
};

/// Whether passes of a phase run once a step.
constexpr bool is_once_a_step(Phase phase) {
  return phase <= Phase::sort;
}

struct Pass {
  Phase phase;
  std::string name; ///< in tables of times; where it is empty, the time counts for the pass before
  std::function<void(Step&)> run; ///< does the work, and books in Step::energy what it has measured
  double seconds = 0.0;           ///< that it has taken so far
};

} // namespace tremolo::mpm_domain
