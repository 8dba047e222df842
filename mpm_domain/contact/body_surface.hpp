#pragma once

#include "base/vector.hpp"
#include "mesh/quadtree.hpp"
#include "mpm_domain/kernel/lanes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tremolo::mpm_domain {

/// The outline of a body as a polygon, counter-clockwise. Its points are corners where it turns by more than
/// 20 degrees at the start; the others belong to something round, or lie on edges that bend.
class BodySurface {
public:
  BodySurface() = default;
  explicit BodySurface(std::vector<Vector> points);

  const std::vector<Vector>& points() const { return points_; } ///< m
  /// Moves the points.
  void place(std::vector<Vector> points);

  const mesh::Rectangle& bounds() const { return bounds_; }
  bool contains(const Vector& position) const;

  /// The point of the outline next to a given one, how far that lies outside (m; negative inside), the normal
  /// there, out of the body, and whether it is a corner.
  struct Nearest {
    double distance;
    Vector normal;
    bool corner;
  };
  Nearest nearest(const Vector& position) const;

  /// Whether the normal of an edge is within 45 degrees of a direction.
  static bool faces(const Vector& normal, const Vector& direction);

  /// The point next to a given one on the edges that face a direction, and whether that is a toe, a corner
  /// that sticks out, beyond which the point lies.
  struct Foot {
    Vector position;
    bool toe;
  };
  std::optional<Foot> foot(const Vector& position, const Vector& direction) const;

  /// A toe, and the normals of the edges that meet there.
  struct Toe {
    Vector position;
    std::array<Vector, 2> normals;
  };
  std::vector<Toe> toes() const;

private:
  enum class Point : std::uint8_t { round, toe, inner_corner };

  /// The point before one.
  std::size_t before(std::size_t k) const { return k == 0 ? points_.size() - 1 : k - 1; }
  /// Four edges, which are looked at together. The last four are filled up with the last edge.
  struct FourEdges {
    Lanes from_x{}, from_y{}; ///< the point where an edge begins, m
    Lanes x{}, y{};           ///< from there to its end, m
    Lanes per_length2{};      ///< 1/m2
  };
  /// The edge next to a point, by the corner where it ends.
  std::size_t nearest_edge(const Vector& position) const;

  std::vector<Point> kinds_;
  // These quantities move with the points:
  std::vector<Vector> points_;
  std::vector<Vector> normals_; ///< of the edge that ends at a point, out of the body
  std::vector<FourEdges> edges_;
  mesh::Rectangle bounds_{};
};

/// A box with a margin (m) around it.
mesh::Rectangle widened(const mesh::Rectangle& box, double margin);

} // namespace tremolo::mpm_domain
