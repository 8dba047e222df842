#pragma once

#include "results/hdf5/hdf5_read.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tremolo::results {

/// The parts of a run that are shown as lines: boundary faces, which stay where they are, and outlines of
/// structures, axes of linings and props, whose points do not.
struct Shapes {
  std::vector<std::int64_t> connectivity; ///< points of one line after the other
  std::vector<std::int64_t> offsets;      ///< lines + 1: where each begins in `connectivity`
  std::vector<std::int32_t> parts;        ///< of each point: one of those below
  std::vector<double> fixed;              ///< x, y, 0 of the points of faces, which are the first, m
  std::vector<double> moving;             ///< x, y, 0 of the others, one time after the other, m
  std::size_t count() const { return parts.size(); }
};

inline constexpr std::int32_t part_of_faces = 1;
inline constexpr std::int32_t part_of_bodies = 2;
inline constexpr std::int32_t part_of_structures = 3; ///< particles of elastic ones, which are no lines
inline constexpr std::int32_t part_of_linings = 4;
inline constexpr std::int32_t part_of_props = 5;

/// Finds the lines of a run, and where they are at the times (s) of its frames.
Shapes shapes_of(const FileReader& run, std::span<const double> times);

} // namespace tremolo::results
