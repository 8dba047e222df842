#pragma once

// Positions of the nodes of a lining's beam: in front of each is a corner of the polygon that the domain uses
// as the outer face. Corners of the case's outline and hinges have nodes; the edges between them are cut into
// equal elements, 64 around at least and none longer than a cell.

#include "scene/case.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::scene {

struct BeamOutline {
  Polygon corners;                 ///< counter-clockwise
  std::vector<std::size_t> hinges; ///< numbers of corners
};

/// @param lining     whose outline is a simple polygon
/// @param cell_size  of the cells that it meets soil on, m
BeamOutline beam_outline(const Lining& lining, double cell_size);

/// The point on a polygon's edges that is next to a point.
Point nearest_on(const Polygon& polygon, Point to);

} // namespace tremolo::scene
