#pragma once

// A rectangle of ground in square cells, for tests of steady flow.

#include "seepage/steady_flow.hpp"

#include <cmath>
#include <cstddef>
#include <functional>

namespace tremolo::test_support {

struct SeepageBlock {
  std::size_t columns, rows; ///< of cells
  double cell;               ///< m
  seepage::FlowProblem problem;

  /// @param permeability  (x, y of a cell's centre) -> m/s
  SeepageBlock(double width, double height, double size,
               const std::function<double(double, double)>& permeability)
      : columns(static_cast<std::size_t>(std::lround(width / size))),
        rows(static_cast<std::size_t>(std::lround(height / size))), cell(size) {
    for (std::size_t j = 0; j <= rows; ++j)
      for (std::size_t i = 0; i <= columns; ++i)
        problem.nodes.push_back({static_cast<double>(i) * size, static_cast<double>(j) * size});
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns; ++i)
        problem.elements.push_back(
            {{node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)},
             4,
             permeability((static_cast<double>(i) + 0.5) * size, (static_cast<double>(j) + 0.5) * size)});
    problem.conditions.resize(problem.nodes.size(), seepage::Condition::none);
    problem.given.resize(problem.nodes.size(), 0.0);
    problem.transition = 0.25 * size;
  }

  std::size_t node(std::size_t i, std::size_t j) const { return j * (columns + 1) + i; }

  void give(std::size_t n, double head) {
    problem.conditions[n] = seepage::Condition::head;
    problem.given[n] = head;
  }

  /// A dam with vertical faces between two waters.
  void stand_between(double left, double right) {
    for (std::size_t j = 0; j <= rows; ++j) {
      const double y = problem.nodes[node(0, j)].y;
      if (y <= left)
        give(node(0, j), left);
      if (y <= right)
        give(node(columns, j), right);
      else
        problem.conditions[node(columns, j)] = seepage::Condition::exit;
    }
  }

  /// Where the pressure is zero in a column of nodes, m.
  double surface(const seepage::SteadyFlow& flow, std::size_t i) const {
    for (std::size_t j = 0; j < rows; ++j) {
      const double below = flow.heads[node(i, j)] - problem.nodes[node(i, j)].y;
      const double above = flow.heads[node(i, j + 1)] - problem.nodes[node(i, j + 1)].y;
      if (below >= 0.0 && above < 0.0)
        return problem.nodes[node(i, j)].y + cell * below / (below - above);
    }
    return static_cast<double>(rows) * cell;
  }
};

} // namespace tremolo::test_support
