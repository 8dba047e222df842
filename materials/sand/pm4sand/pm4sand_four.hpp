#pragma once

// Four points of PM4Sand side by side, a lane each: every number of a point becomes four.

#include "materials/sand/pm4sand/pm4sand_state.hpp"

#include "base/lanes.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace tremolo::materials::pm4 {

using Deviators = DeviatorOf<Lanes>;
using Stresses = StressOf<Lanes>;
using Motions = MotionOf<Lanes>;
using Initials = InitialOf<Lanes>;
using Memories = MemoryOf<Lanes>;
using States = StateOf<Lanes>;

/// a in the lanes of a mask, b in the others.
inline Deviators choose(const LaneMask& mask, const Deviators& a, const Deviators& b) {
  return {tremolo::choose(mask, a.d, b.d), tremolo::choose(mask, a.s, b.s)};
}
inline Stresses choose(const LaneMask& mask, const Stresses& a, const Stresses& b) {
  return {tremolo::choose(mask, a.p, b.p), choose(mask, a.s, b.s)};
}
inline Motions choose(const LaneMask& mask, const Motions& a, const Motions& b) {
  return {choose(mask, a.alpha, b.alpha),
          choose(mask, a.z, b.z),
          tremolo::choose(mask, a.z_cum, b.z_cum),
          tremolo::choose(mask, a.z_peak, b.z_peak),
          tremolo::choose(mask, a.volumetric_strain, b.volumetric_strain),
          tremolo::choose(mask, a.gap, b.gap)};
}

/// The memory of one of the four.
inline Memory memory_of(const Memories& four, std::size_t lane) {
  constexpr std::size_t count = sizeof(Memory) / sizeof(double);
  const auto from = std::bit_cast<std::array<Lanes, count>>(four);
  std::array<double, count> to;
  for (std::size_t i = 0; i < count; ++i)
    to[i] = from[i][lane];
  return std::bit_cast<Memory>(to);
}

inline void set_memory(const Memory& memory, std::size_t lane, Memories& four) {
  constexpr std::size_t count = sizeof(Memory) / sizeof(double);
  const auto from = std::bit_cast<std::array<double, count>>(memory);
  auto to = std::bit_cast<std::array<Lanes, count>>(four);
  for (std::size_t i = 0; i < count; ++i)
    to[i][lane] = from[i];
  four = std::bit_cast<Memories>(to);
}

} // namespace tremolo::materials::pm4
