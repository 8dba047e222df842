#pragma once

// [random_profile]: one of many profiles of Vs that a site may have, by Toro's model (toro.hpp).

#include "scene/random/toro.hpp"

#include <cstdint>
#include <vector>

namespace tremolo::scene {

/// Within how many sigma_ln of its median Vs stays, as practice has it (EPRI 2013, Seismic evaluation
/// guidance: screening, prioritization and implementation details, Technical Report 1025287).
inline constexpr double most_deviations = 2.0;

/// Ground of one factor.
struct RandomLayer {
  double top = 0.0;    ///< y, m
  double bottom = 0.0; ///< y, m
  double factor = 1.0; ///< Vs over that of the case
};

/// A realisation of Vs. Every y has one factor, wherever the ground of [[profile]] lies.
struct RandomProfile {
  ToroModel model;
  double layer_thickness = 0.0; ///< thicker layers are cut, m
  std::uint32_t seed = 0;
  std::uint32_t realisation = 0;
  std::vector<RandomLayer> layers; ///< from the surface down to the half-space

  /// The factor at a level (m): that of the uppermost layer above it, 1 in the half-space.
  double factor_at(double y) const;
  /// The y of the interfaces between two levels, from the top down, m.
  std::vector<double> interfaces(double high, double low) const;
};

/// Cuts layers into equal parts that are not thicker than `profile.layer_thickness`, and draws a factor for
/// each part.
/// @param surface      y, m
/// @param thicknesses  of the layers of [[profile]], m
void realise(RandomProfile& profile, double surface, const std::vector<double>& thicknesses);

} // namespace tremolo::scene
