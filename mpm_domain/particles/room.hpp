#pragma once

// Where the arrays of many particles lie. Arrays of one length that come from the system one after the other
// lie at equal distances. A step reads some twenty of them side by side, and at some distances they take
// turns in the same few places of a processor's caches and page tables: ten million particles then take a
// seventh longer (docs/performance.md). So long arrays get some pages more, each its own number of them.

#include "mpm_domain/particles/particles.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// Numbers that an array is to have room for.
/// @param size   numbers that it holds
/// @param array  its number among those that are read side by side
inline std::size_t room_for(std::size_t size, std::size_t array) {
  constexpr std::size_t long_one = std::size_t{1} << 20; // fewer numbers gained nothing
  constexpr std::size_t page = 4096 / sizeof(double);
  return size < long_one ? size : size + 37 * array % 61 * page;
}

/// Moves the fields of a set to arrays with such room.
inline void spread_out(Particles& set) {
  std::size_t array = 0;
  set.for_fields([&](const ParticleFieldDescription&, std::vector<double>& values) {
    std::vector<double> moved;
    moved.reserve(room_for(values.size(), array++));
    moved.assign(values.begin(), values.end());
    values = std::move(moved);
  });
}

} // namespace tremolo::mpm_domain
