#pragma once

// The joint of the matched layers of a side and of the base: rotations between the directions of the layers,
// (along, normal), and those of the corner between them, x outwards from the side and z downwards from the
// base:
//
//     side (along is up):             x = normal, z = -along,
//     base (along is to the right):   x = -along at the left side, along at the right one, z = normal.

#include "mpm_domain/boundary/layer/layer_corner.hpp"
#include "mpm_domain/boundary/layer/layer_lattice.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The corner between two layers, which both have an end of the kind LayerEnd::corner there. It has the
/// material at the end of the base's layer.
class LayerJoint {
public:
  /// @param side left or right
  LayerJoint(Side side, LayerLattice& side_layer, LayerLattice& base_layer);

  /// Moves the corner over the next dt (s), and passes the motion of their shared ends to the layers: before
  /// they move.
  /// @param side_velocity, base_velocity  of the layers' nodes at the domain's corner, in their own
  /// directions
  void advance(double dt, eq6::Vector side_velocity, eq6::Vector base_velocity, LayerLattice& side_layer,
               LayerLattice& base_layer);
  /// Adds the corner's force to the layers' nodes at the domain's corner: after they have moved.
  void pull(LayerLattice& side_layer, LayerLattice& base_layer) const;

  /// Adds all that changes with time, for a checkpoint.
  void add_state(SavedNumbers& state) { corner_.add_state(state); }

  /// The end of the base's layer that meets the corner: 0 is its left one, 1 its right one.
  [[nodiscard]] std::size_t base_end() const { return outwards_ < 0.0 ? 0 : 1; }

private:
  [[nodiscard]] eq6::Vector of_base(eq6::Vector v) const { return {outwards_ * v.x, v.y}; } ///< and back
  static eq6::Vector of_side(eq6::Vector v) { return {v.y, -v.x}; }
  static eq6::Vector to_side(eq6::Vector v) { return {-v.y, v.x}; }

  double outwards_; ///< along the base: -1 at the left side, 1 at the right one
  std::size_t cells_;
  LayerCorner corner_;
};

} // namespace tremolo::mpm_domain
