#pragma once

// Loads on the surface of the soil: a pressure p along its inward normal and a shear s along it, towards +x.
// They act on the uppermost particles between two positions and go with them. A line through the middles of
// their upper edges, cut at J half way between two of them (in proportion to their widths), gives each
// particle a chord
//
//     e_f = J_f - J_{f-1},        F_f = p (e_y, -e_x) + s (e_x, e_y),
//
// of which the first and the last particle take the part that the load covers at the start, so that the
// pressure follows the normal of the moved surface and counts per present length, and all chords add up to
// the way from end to end: the sum of the forces is exact however the surface is bent. The nodes receive F_f
// W, with the weights of boundary faces (boundary_faces.hpp), which balance a uniform stress in level ground
// exactly.
//
// The work of loads is booked as that of static tractions.

#include "mpm_domain/boundary/boundary_faces.hpp"
#include "mpm_domain/passes/pass.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The part of a load that one particle carries.
struct LoadedFace {
  std::size_t load = 0; ///< index into Spec::loads
  std::size_t set = 0;
  std::uint32_t id = 0; ///< the particle
  double offset = 0.0;  ///< of the middle of the loaded width from its own, along x at the start, m
  double half = 0.0;    ///< of the loaded width at the start, m
  Vector force;         ///< of the present, N/m
  FaceWeights weights = {};
};

class SurfaceLoads {
public:
  /// Finds the particles that carry the loads of the spec. Those that grow while the ground is in motion do
  /// not act yet; all others are at their full size.
  /// @param ground  at the start; all ranks that have filled it call this
  /// @throws std::invalid_argument for a load with no soil below it
  explicit SurfaceLoads(Ground& ground);

  bool any() const { return !faces_.empty(); }
  /// The loaded faces, load after load, each from left to right.
  std::span<const LoadedFace> faces() const { return faces_; }

  /// Lets a load act with a share (1) of its size.
  void scale(std::size_t load, double share) { share_[load] = share; }
  /// Lets those that grow while the ground is in motion be as large as they are at a time of the simulation,
  /// s.
  void grow(const Spec& spec, double time);
  /// Around the particles here that carry each load; where there are none, around nothing.
  std::vector<mesh::Rectangle> bounds(const Ground& ground) const;
  /// Brings forces and weights to where the soil is.
  void follow(const Ground& ground);
  /// Adds the forces to those of the nodes.
  void add(Grid& grid) const;
  /// Power of the forces on the mean of velocities before and after the last update, W/m.
  double power(const Grid& grid) const;
  /// Leaves the forces out of the power that the remapped velocity makes.
  void take_off_remap_power(Step& step) const;

private:
  std::vector<LoadedFace> faces_;
  std::vector<double> share_; ///< by load
};

/// The loads in a step; none where there are none.
std::vector<Pass> load_passes(Ground& ground, SurfaceLoads& loads);

} // namespace tremolo::mpm_domain
