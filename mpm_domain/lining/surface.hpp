#pragma once

// The surface of a lining as the beam carries it. A point X of the surface belongs to the element behind its
// edge of the outline, at the foot c = (1 - xi) x_a + xi x_b, and keeps its arm X - c in the frame of that
// chord. Its velocity is
//
//     H v = sum_k w_k (v_k + theta'_k e_z x (X - c)),        w = (1 - xi, xi),
//
// that of the beam's sections, linear in between. It reproduces rigid motion exactly, and its transpose gives
// an impulse at X back to the nodes with its moment about the axis: shear on the surface bends the beam.
//
// The surface is cut into segments of about one cell, which end where it has a corner. Soil and lining meet
// by the means of their velocities over segments (segment_rows.hpp).

#include "mpm_domain/lining/beam/beam.hpp"
#include "mpm_domain/spec/lining.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace tremolo::mpm_domain {

/// A point of the surface, and where the beam carries it.
struct SurfacePoint {
  std::size_t element = 0;
  double along = 0.0; ///< xi
  Vector arm;         ///< from the foot, along the chord and to its left, m
};

/// Contribution of a degree of freedom to a velocity.
struct BeamShare {
  std::size_t dof;
  Vector velocity; ///< m/s for each m/s or rad/s
};

struct SurfaceSegment {
  static constexpr std::size_t point_count = 8;
  std::array<SurfacePoint, point_count> points; ///< in equal distances
  std::size_t carrier = 0;                      ///< element that carries its middle
  Vector normal;                                ///< into the lining, in the frame of that element's chord
  double length = 0.0;                          ///< m
};

class LiningSurface {
public:
  /// @param beam  of the lining, as it stands at the start
  /// @param cell  about the length of segments, m
  LiningSurface(const Lining& lining, const Beam& beam, double cell);

  const std::vector<SurfaceSegment>& segments() const { return segments_; }
  /// Points in front of the nodes, counter-clockwise, m.
  std::vector<Vector> corners(const Beam& beam) const;

private:
  std::vector<SurfaceSegment> segments_;
  std::vector<SurfacePoint> corners_;
};

/// The axis of the beam of a lining: its nodes, t/2 behind the corners of the outline.
/// @throws std::invalid_argument where the outline is not a polygon that runs counter-clockwise, or too
/// narrow for the lining's thickness
BeamShape shape_of(const Lining& lining);

/// Present position of a point of the surface.
Vector position_of(const SurfacePoint& point, const Beam& beam);
/// The foot of a point on the beam's axis.
Vector foot(const SurfacePoint& point, const Beam& beam);
/// The normal of a segment now, from soil to lining.
Vector normal(const SurfaceSegment& segment, const Beam& beam);

/// Adds a share of H for a point that the beam carries like one of its surface.
void add_velocity(const SurfacePoint& point, const Vector& at, double share, const Beam& beam,
                  std::vector<BeamShare>& to);

} // namespace tremolo::mpm_domain
