#pragma once

// The head of the ground water before it is disturbed,
//
//     h(x, y) = p/gamma + y,      gamma = rho_f g,
//
// m, which is all that the domain knows of it: soil is wet where h > y, its pressure is p = gamma (h - y),
// and what it does to the soil besides lifting it is the seepage force -gamma grad h per volume. Water at
// rest below a level table has one head. Below a line that is not level it has that of the line above, which
// is not flow: nothing balances the force across. Steady flow has heads on a grid (seepage_of_ground.hpp).

#include "base/vector.hpp"

#include <variant>
#include <vector>

namespace tremolo::mpm_domain {

/// Heads at nodes of a square grid, row after row, bilinear between them.
struct HeadGrid {
  double x0 = 0.0, y0 = 0.0; ///< of the first node, m
  double h = 1.0;            ///< m
  std::size_t columns = 0, rows = 0;
  std::vector<double> heads; ///< m

  Vector position(std::size_t i, std::size_t j) const {
    return {x0 + static_cast<double>(i) * h, y0 + static_cast<double>(j) * h};
  }
  std::size_t node(std::size_t i, std::size_t j) const { return j * columns + i; }
};

/// The head at a point.
struct HeadThere {
  double head = 0.0; ///< m
  Vector slope;      ///< grad h, 1
};

class Head {
public:
  /// Below a level table (m).
  explicit Head(double level) : field_(level) {}
  /// Below a line from left to right, m; beyond its ends it is level.
  explicit Head(std::vector<Vector> line) : field_(std::move(line)) {}
  /// Beyond the grid, the heads are those of its edge.
  explicit Head(HeadGrid grid) : field_(std::move(grid)) {}

  /// The level of the table, m; nothing if the head is not the same everywhere.
  const double* level() const { return std::get_if<double>(&field_); }
  HeadThere at(double x, double y) const;
  /// Whether a point lies below the phreatic surface.
  bool is_wet(double x, double y) const { return at(x, y).head > y; }
  /// The highest point at x with water below it, between two levels, m; `low` where there is none.
  double surface(double x, double low, double high) const;

private:
  std::variant<double, std::vector<Vector>, HeadGrid> field_;
};

} // namespace tremolo::mpm_domain
