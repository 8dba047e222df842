#pragma once

// The soils below a point: in the domain along a vertical line, in a free field below its surface. Vertical
// effective stress is what the ground above weighs,
//
//     sigma'_v(y) = g int_y^surface rho' dy,
//
// with rho' the density of dry soil above the water table and the buoyant one, rho - rho_w, below it
// (Terzaghi 1943, Theoretical soil mechanics).

#include "scene/case.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace tremolo::scene {

/// Ground between two levels.
struct GroundPiece {
  double top = 0.0;                ///< y, m
  double bottom = 0.0;             ///< y, m
  std::optional<std::size_t> soil; ///< index into Case::soils; without one linear elastic
  materials::Elasticity elastic;   ///< of the soil's law, or as the layer gives it
  double table = -std::numeric_limits<double>::infinity(); ///< y of the water table there, m
};

/// The pieces are ordered from the top down.
using GroundColumn = std::vector<GroundPiece>;

/// The levels (m) at which the vertical line at x (m) crosses a polygon's edges, from the top down.
std::vector<double> crossings(const Polygon& polygon, double x);

/// The layers under a surface, and the half-space down to a level (m) below them.
/// @param table  y of the water table, m; without [water] it counts for nothing
GroundColumn ground_of_layers(const Case& scene, double surface, double table,
                              const std::vector<Layer>& layers, double down_to);

/// The ground of a side's free field, down to the base of the model at least.
GroundColumn ground_of_free_field(const Case& scene, const LateralBoundary& side);

/// The soils of the regions along the vertical line at x (m).
GroundColumn ground_of_domain(const Case& scene, double x);

/// sigma'_v at a level (m) of a column, Pa, positive in compression, with water at rest. Gravity is that of
/// the case, 9.81 m/s2 where it has none.
double vertical_stress(const Case& scene, const GroundColumn& ground, double y);

} // namespace tremolo::scene
