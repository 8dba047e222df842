#pragma once

#include "mesh/quadtree.hpp"
#include "mpm_domain/spec/vector.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// The outline of a body as a polygon, counter-clockwise. Its points are corners, or lie on edges that bend.
class BodySurface {
public:
  BodySurface() = default;
  /// @param corner  which points are corners
  BodySurface(std::vector<Vector> points, std::vector<bool> corner);

  const std::vector<Vector>& points() const { return points_; } ///< m
  /// Moves the points.
  void place(std::vector<Vector> points) { points_ = std::move(points); }

  mesh::Rectangle bounds() const;
  bool contains(const Vector& place) const;

  /// The point of the outline next to a place, how far that lies outside (m; negative inside), the normal
  /// there, out of the body, and whether it is a corner.
  struct Nearest {
    double distance;
    Vector normal;
    bool corner;
  };
  Nearest nearest(const Vector& place) const;

private:
  std::vector<Vector> points_;
  std::vector<bool> corner_;
};

} // namespace tremolo::mpm_domain
