#pragma once

// Soil and lining in a step, at all segments at once. With trial velocities w* of the soil's nodes and v* of
// the beam, both without contact,
//
//     v+ = v* + A^-1 H^T j,        w+ = w* - m^-1 B^T j,
//
// j being the impulses that segment_contact.hpp finds. Gaps are displacements: both touch at the start, and a
// gap grows by dt n.(H v+ - B w+) where they part. So soil that comes back is met where it had left, and not
// a cell before. Where water flows, m^-1 is the answer of grains and water together (soil_motion.hpp).

#include "mpm_domain/lining/segment_contact.hpp"
#include "mpm_domain/lining/segment_rows.hpp"
#include "mpm_domain/lining/segment_soil.hpp"
#include "mpm_domain/lining/soil_motion.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class BeamStep;

/// The pore water before a lining.
struct WaterBefore {
  std::vector<WetNode> nodes; ///< in their order
  std::vector<double> least;  ///< pressure that it may fall to, by row, Pa
};

class LiningContact {
public:
  explicit LiningContact(const LiningSurface& surface);

  /// The contacts by segment; the caller sets friction and adhesion (Pa).
  std::vector<SegmentContact>& segments() { return segments_; }
  const std::vector<SegmentContact>& segments() const { return segments_; }
  const std::vector<double>& gaps() const { return gaps_; } ///< m

  /// Finds the impulses, which stay until the next ones.
  /// @param soil    after its own update
  /// @param kick    time that forces act for, s
  /// @param dt      time that places move for, s
  /// @param bonded  both stick together, whatever that takes
  /// @param water   before the lining; no nodes: the soil is dry
  /// @returns velocities of the beam
  std::vector<double> meet(std::span<const SegmentRows> rows, const SoilMotion& soil, const BeamStep& step,
                           double kick, double dt, bool bonded, const WaterBefore& water = {});
  /// Velocity changes of the soil's nodes by the impulses, in their order.
  std::vector<NodeChange> changes(std::span<const SegmentRows> rows, const SoilMotion& soil) const;
  /// The impulse on the lining at a segment, kg/s.
  Vector impulse(const SegmentRows& rows) const;
  /// Lets gaps follow final velocities.
  /// @param v  of the beam
  void follow_gaps(std::span<const SegmentRows> rows, const SoilMotion& soil, std::span<const double> v,
                   double dt);

  /// Velocity changes of the soil's nodes by impulses on an immovable lining that stop soil from moving into
  /// tied segments, and along those that stick, with the rows and masses of the last step.
  std::vector<NodeChange> stopped(std::span<const SegmentRows> rows, const SoilMotion& soil,
                                  std::span<const double> v) const;

  /// Gaps and sets, for a checkpoint, and back.
  std::vector<double> state() const;
  /// @throws std::runtime_error for those of another lining
  void set_state(std::span<const double> state);

private:
  std::vector<SegmentContact> segments_;
  std::vector<double> lengths_; ///< m
  std::vector<double> gaps_;
  SegmentSoil soil_; ///< of the last step
};

} // namespace tremolo::mpm_domain
