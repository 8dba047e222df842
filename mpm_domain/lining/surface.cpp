#include "mpm_domain/lining/surface.hpp"

#include "mesh/polygon_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Sine of the angle by which an outline turns at a corner, at least.
const double least_turn = std::sin(20.0 * std::numbers::pi / 180.0);

Vector between(const Vector& a, const Vector& b, double share) {
  return a + share * (b - a);
}

Vector unit(const Vector& v) {
  return v / std::sqrt(square(v));
}

/// Into the body, for an edge of an outline that runs counter-clockwise.
Vector inward(const Vector& a, const Vector& b) {
  const Vector along = unit(b - a);
  return {-along.y, along.x};
}

/// A vector of the frame of an axis in the frame of the plane.
Vector turned(const Vector& axis, const Vector& v) {
  return {axis.x * v.x - axis.y * v.y, axis.y * v.x + axis.x * v.y};
}

Vector turned_back(const Vector& axis, const Vector& v) {
  return turned({axis.x, -axis.y}, v);
}

/// The nodes that an element joins.
struct Ends {
  Vector a, b;

  Ends(const Beam& beam, std::size_t element) {
    const auto q = beam.positions();
    const auto& dofs = beam.elements()[element].dofs;
    a = {q[dofs[0]], q[dofs[1]]};
    b = {q[dofs[3]], q[dofs[4]]};
  }
};

SurfacePoint carried(const Vector& at, std::size_t element, const Beam& beam) {
  const Ends ends(beam, element);
  const Vector chord = ends.b - ends.a;
  const double xi = std::clamp(dot(at - ends.a, chord) / square(chord), 0.0, 1.0);
  return {element, xi, turned_back(beam.place_of_element(element).axis, at - between(ends.a, ends.b, xi))};
}

/// A point on the outline, the normal there, into the body, and the number of its edge.
struct RunPlace {
  Vector position, normal;
  std::size_t edge;
};

/// A way along the outline from one corner of it to the next, or once around one without corners.
struct Run {
  std::vector<Vector> points;
  std::size_t first = 0; ///< number of its first edge; that of the last may be beyond those of the outline

  double length() const {
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      sum += std::hypot(points[k + 1].x - points[k].x, points[k + 1].y - points[k].y);
    return sum;
  }
  /// The point at a distance (m) from its beginning.
  RunPlace at(double distance) const {
    for (std::size_t k = 0;; ++k) {
      const double edge = std::hypot(points[k + 1].x - points[k].x, points[k + 1].y - points[k].y);
      if (distance <= edge || k + 2 == points.size())
        return {between(points[k], points[k + 1], distance / edge), inward(points[k], points[k + 1]),
                first + k};
      distance -= edge;
    }
  }
};

std::vector<Run> runs_of(const std::vector<Vector>& outline) {
  const std::size_t n = outline.size();
  const auto is_corner = [&](std::size_t k) {
    const Vector in = unit(outline[k] - outline[(k + n - 1) % n]);
    const Vector out = unit(outline[(k + 1) % n] - outline[k]);
    return std::abs(cross(in, out)) > least_turn || dot(in, out) < 0.0;
  };
  std::size_t start = 0;
  while (start < n && !is_corner(start))
    ++start;
  start %= n;
  std::vector<Run> runs;
  Run run{{outline[start]}, start};
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t at = (start + k) % n;
    run.points.push_back(outline[at]);
    if (k == n || is_corner(at)) {
      runs.push_back(run);
      run = {{outline[at]}, at};
    }
  }
  return runs;
}

} // namespace

LiningSurface::LiningSurface(const Lining& lining, const Beam& beam, double cell) {
  for (const Run& run : runs_of(lining.outline)) {
    const auto count = static_cast<std::size_t>(std::max(1.0, std::round(run.length() / cell)));
    const double length = run.length() / static_cast<double>(count);
    for (std::size_t s = 0; s < count; ++s) {
      SurfaceSegment segment;
      segment.length = length;
      Vector facing{};
      for (std::size_t q = 0; q < segment.points.size(); ++q) {
        const double share = (static_cast<double>(q) + 0.5) / static_cast<double>(segment.points.size());
        const RunPlace on = run.at((static_cast<double>(s) + share) * length);
        segment.points[q] = carried(on.position, on.edge % beam.elements().size(), beam);
        facing += on.normal;
      }
      segment.carrier = run.at((static_cast<double>(s) + 0.5) * length).edge % beam.elements().size();
      segment.normal = turned_back(beam.place_of_element(segment.carrier).axis, unit(facing));
      segments_.push_back(segment);
    }
  }
  for (std::size_t k = 0; k < lining.outline.size(); ++k)
    corners_.push_back(carried(lining.outline[k], k, beam));
}

std::vector<Vector> LiningSurface::corners(const Beam& beam) const {
  std::vector<Vector> now;
  for (const SurfacePoint& corner : corners_)
    now.push_back(position_of(corner, beam));
  return now;
}

BeamShape shape_of(const Lining& lining) {
  const std::vector<Vector>& outline = lining.outline;
  const std::size_t n = outline.size();
  if (n < 3 || !(mesh::signed_double_area(outline) > 0.0))
    throw std::invalid_argument(fmt::format(
        "the outline of lining '{}' has {} corners; allowed: 3 or more, counter-clockwise around some area",
        lining.name, n));
  BeamShape shape{.nodes = {}, .closed = true, .hinges = lining.hinges};
  for (std::size_t k = 0; k < n; ++k) {
    // Both edges move inward by t/2; their lines meet at the node.
    const Vector in = inward(outline[(k + n - 1) % n], outline[k]);
    const Vector out = inward(outline[k], outline[(k + 1) % n]);
    const double scale = 0.5 * lining.thickness / (1.0 + dot(in, out));
    shape.nodes.push_back(outline[k] + scale * (in + out));
  }
  for (std::size_t k = 0; k < n; ++k)
    if (dot(outline[(k + 1) % n] - outline[k], shape.nodes[(k + 1) % n] - shape.nodes[k]) <= 0.0)
      throw std::invalid_argument(
          fmt::format("lining '{}' is {:.6g} m thick, too much for its outline beside "
                      "x = {:.6g} m, y = {:.6g} m",
                      lining.name, lining.thickness, outline[k].x, outline[k].y));
  return shape;
}

Vector foot(const SurfacePoint& point, const Beam& beam) {
  const Ends ends(beam, point.element);
  return between(ends.a, ends.b, point.along);
}

Vector position_of(const SurfacePoint& point, const Beam& beam) {
  return foot(point, beam) + turned(beam.place_of_element(point.element).axis, point.arm);
}

Vector normal(const SurfaceSegment& segment, const Beam& beam) {
  return turned(beam.place_of_element(segment.carrier).axis, segment.normal);
}

void add_velocity(const SurfacePoint& point, const Vector& at, double share, const Beam& beam,
                  std::vector<BeamShare>& to) {
  const Vector arm = at - foot(point, beam);
  const auto& dofs = beam.elements()[point.element].dofs;
  for (const std::size_t end : {0U, 3U}) {
    const double w = share * (end == 0 ? 1.0 - point.along : point.along);
    const BeamShare turn{dofs[end + 2], {-w * arm.y, w * arm.x}};
    auto found = std::ranges::find(to, dofs[end], &BeamShare::dof);
    if (found == to.end()) {
      to.insert(found, {{dofs[end], {w, 0.0}}, {dofs[end + 1], {0.0, w}}, turn});
      continue;
    }
    found->velocity.x += w; // its y stands behind it, and then a turn, of which hinges have two
    (++found)->velocity.y += w;
    found = std::find_if(found, to.end(), [&](const BeamShare& of) { return of.dof == turn.dof; });
    if (found == to.end())
      to.push_back(turn);
    else
      found->velocity += turn.velocity;
  }
}

} // namespace tremolo::mpm_domain
