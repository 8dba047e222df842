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

/// Reads the blocks of one to four points; the lanes beyond them repeat the first.
inline States load_four(const double* blocks, std::size_t count) {
  std::array<const double*, 4> of_point;
  for (std::size_t lane = 0; lane < of_point.size(); ++lane)
    of_point[lane] = blocks + (lane < count ? lane * state_size : 0);
  std::array<Lanes, state_size> values;
  for (std::size_t i = 0; i < state_size; i += 4) {
    const std::array<Lanes, 4> part =
        transposed({tremolo::load(of_point[0] + i), tremolo::load(of_point[1] + i),
                    tremolo::load(of_point[2] + i), tremolo::load(of_point[3] + i)});
    std::memcpy(&values[i], &part, sizeof(part));
  }
  return std::bit_cast<States>(values);
}

inline void store_four(const States& states, double* blocks, std::size_t count) {
  const auto values = std::bit_cast<std::array<Lanes, state_size>>(states);
  for (std::size_t i = 0; i < state_size; i += 4) {
    const std::array<Lanes, 4> part = transposed({values[i], values[i + 1], values[i + 2], values[i + 3]});
    for (std::size_t lane = 0; lane < count; ++lane)
      tremolo::store(blocks + lane * state_size + i, part[lane]);
  }
}

} // namespace tremolo::materials::pm4
