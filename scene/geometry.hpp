#pragma once

// Plane geometry of case files. x to the right, y up, m.

#include "base/vector.hpp"
#include "mesh/quadtree.hpp"

#include <functional>
#include <vector>

namespace tremolo::scene {

using Point = Vector;

/// Corners in either sense of rotation; the last is joined to the first.
using Polygon = std::vector<Point>;

using Box = mesh::Rectangle;

/// A polygon of 64 corners with the area of a circle, counter-clockwise.
Polygon circle(Point centre, double radius);

/// Points from one end of a straight line to the other, both included, evenly and at most `spacing` (m)
/// apart.
std::vector<Point> points_along(Point from, Point to, double spacing);

/// Enclosed area, m2.
double area(const Polygon& polygon);

/// Length of all edges, m.
double perimeter(const Polygon& polygon);

/// Cuts what the edges of a polygon have below a level (m) into pieces, and visits them from end to end.
/// @param longest  of a piece, m
void for_pieces(const Polygon& polygon, double level, double longest,
                const std::function<void(Point from, Point to)>& visit);

/// Whether p lies inside the polygon or on its edge.
bool contains(const Polygon& polygon, Point p);

/// Whether p lies inside the polygon and not on its edge.
bool strictly_inside(const Polygon& polygon, Point p);

/// Whether two edges of the polygon that are not neighbours meet, or neighbours fold back on each other.
bool intersects_itself(const Polygon& polygon);

/// Whether `inner` lies in `outer` and the edges of the two do not meet.
bool encloses(const Polygon& outer, const Polygon& inner);

/// Whether the interiors of two simple polygons have a point in common; touching along edges or corners is no
/// overlap.
bool overlap(const Polygon& a, const Polygon& b);

} // namespace tremolo::scene
