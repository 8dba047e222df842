#pragma once

// The critical time step of the domain. Every soil and every elastic structure allows one on the cells that
// its particles touch; the smallest applies to all, so that one stiff or strongly damped material makes the
// whole domain slow.

#include "scene/plan/levels.hpp"

#include <span>
#include <string>

namespace tremolo::scene {

struct StepLimit {
  double dt = 0.0;        ///< the critical time step at rest, s
  std::string by;         ///< what sets it: "soil 'rock'"
  double cell_size = 0.0; ///< of the cells on which it does, m
  double others = 0.0; ///< the critical time step without that material, s; infinite where there is no other
  double undamped = 0.0; ///< the critical time step without damping, s
};

/// If each level has its own step, half that of the next coarser level, all steps refer to the coarsest
/// level.
StepLimit step_limit(const Case& scene, std::span<const Level> levels);

/// The critical time step of the domain at rest: the least of its levels, s.
double critical_time_step(const Case& scene, std::span<const Level> levels);

/// "set by soil 'rock' on cells of 0.5 m; 0.0002 s without it, 0.0001 s without damping"
std::string step_limit_text(const StepLimit& limit);

} // namespace tremolo::scene
