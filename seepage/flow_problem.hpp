#pragma once

// The ground that water seeps through, and what is known at its edges: nodes, the elements between them, and
// heads. It knows neither soil nor particles.

#include "base/vector.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace tremolo::seepage {

/// A triangle or a quadrilateral of one permeability.
struct Element {
  std::array<std::size_t, 4> nodes{}; ///< counter-clockwise
  std::size_t corners = 4;            ///< 3 or 4 of them
  double permeability = 0.0;          ///< k of Darcy's law, m/s
};

/// A node's boundary condition.
enum class Condition {
  none, ///< water neither enters nor leaves
  head, ///< the head is given: free water, or a table beside the ground
  exit, ///< the ground is open to the air: water may leave under atmospheric pressure, and none enters
};

struct FlowProblem {
  std::vector<Vector> nodes; ///< m; y is an elevation
  std::vector<Element> elements;
  std::vector<Condition> conditions; ///< by node
  std::vector<double> given;         ///< by node: the head where it is given, m
  /// Depth of suction, as a head, over which the permeability of ground above the phreatic surface falls, m:
  /// a quarter of a cell.
  double transition = 0.0;
};

} // namespace tremolo::seepage
