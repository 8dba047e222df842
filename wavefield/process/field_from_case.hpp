#pragma once

#include "scene/case.hpp"
#include "scene/motion.hpp"
#include "wavefield/half_space_field.hpp"

#include <numbers>

namespace tremolo::wavefield {

/// The incident signal of a case at its reference point.
inline Signal signal_from_case(const scene::Case& scene) {
  const scene::Motion motion = scene::motion(scene.motion);
  return {[motion](double t) { return motion.velocity(t); }, motion.begin(), motion.end(),
          motion.highest_frequency()};
}

/// The exact field of a case's incident wave under a free surface at the given level, m.
/// @throws motion::RecordError for a motion that cannot be read, std::invalid_argument for values out of range
inline HalfSpaceField field_from_case(const scene::Case& scene, double surface_level) {
  const HalfSpace half_space{scene.halfspace.density, scene.halfspace.s_wave_speed(),
                             scene.halfspace.p_wave_speed()};
  const Incidence incidence{scene.motion.wave == scene::Wave::sv ? WaveType::SV : WaveType::P,
                            scene.motion.angle_deg * std::numbers::pi / 180.0, scene.motion.reference.x,
                            scene.motion.reference.y};
  return {half_space, incidence, surface_level, signal_from_case(scene)};
}

} // namespace tremolo::wavefield
