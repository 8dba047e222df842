#pragma once

#include "scene/case.hpp"

#include <optional>
#include <string>

namespace tremolo::scene {

/// Limits that the wet soils which drain set to the time factor F of a rest.
struct FastRest {
  /// Pi = F k sqrt(M rho)/(gamma_w H), 1: the way of the slow wave against that of diffusion, with the
  /// largest k and the largest sqrt(M rho), M the modulus of the skeleton, rho the saturated density, and the
  /// height H from the lowest to the highest of these soils. The error of the settlement is about 0.8 Pi^1.5
  /// of what the rest adds.
  double slow_wave = 0.0;
  double permeability = 0.0;  ///< the largest F k, m/s
  std::string most_permeable; ///< name of the soil that it belongs to
  double ringing = 0.0;       ///< T_u = 4 H_w/c_u, s: the period in which pressure rings in all wet ground

  /// Error of the settlement, relative to what the rest adds, 1.
  double settlement_error() const;
};

/// Empty if there is no rest, no time factor, or no water that flows.
std::optional<FastRest> fast_rest(const Case& scene);

} // namespace tremolo::scene
