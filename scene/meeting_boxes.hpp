#pragma once

// Finds which of many boxes meet without looking at all pairs, and which of many polygons overlap.

#include "scene/geometry.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace tremolo::scene {

/// Relative to the size of the larger box: corners typed as decimals meet exactly on paper.
inline constexpr double box_tolerance = 1e-9;

/// The smallest box around some points.
Box box_of(const std::vector<Point>& points);

/// Whether two boxes have a point in common; edges that touch do.
bool meet(const Box& a, const Box& b);

/// Calls visit(i, j), i < j, for boxes that meet, until it returns true. A line moves along x: each box is
/// compared, in the order of the left edges, with those that have begun and not ended.
/// @returns whether a call returned true
template <class Visit>
bool for_each_meeting_pair(const std::vector<Box>& boxes, const Visit& visit) {
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return boxes[i].x_min; });
  std::vector<std::size_t> begun;
  for (const std::size_t i : order) {
    std::erase_if(begun, [&](std::size_t j) {
      return boxes[j].x_max + box_tolerance * std::max(boxes[j].width(), boxes[i].width()) < boxes[i].x_min;
    });
    for (const std::size_t j : begun)
      if (meet(boxes[i], boxes[j]) && visit(std::min(i, j), std::max(i, j)))
        return true;
    begun.push_back(i);
  }
  return false;
}

/// Finds each simple polygon that overlaps an earlier one: pairs of indices, (the first that it overlaps,
/// itself).
std::vector<std::pair<std::size_t, std::size_t>> overlaps(const std::vector<Polygon>& polygons);

} // namespace tremolo::scene
