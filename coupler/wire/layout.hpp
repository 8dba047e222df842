#pragma once

// Meaning of a step's values in the two kinds of frames between domain and hub (field 0 of either).

#include <cstddef>

namespace tremolo::coupler::layout {

/// Domain to hub, per step: the time (s), then vx, vy of each face (m/s).
constexpr std::size_t velocities(std::size_t faces) {
  return 1 + 2 * faces;
}

/// Hub to domain in mode lockstep, per face: traction x, y (Pa), then what Eq. (6) took of the free field:
/// vx, vy (m/s), sxx, syy, sxy (Pa).
inline constexpr std::size_t per_face = 7;

} // namespace tremolo::coupler::layout
