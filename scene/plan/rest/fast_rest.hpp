#pragma once

#include "scene/case.hpp"

#include <optional>

namespace tremolo::scene {

/// What a rest with a time factor F asks of the ground. Of the wet soils in which water flows, each number is
/// that of the one where it is largest.
struct FastRest {
  /// Pi = F k sqrt(M rho)/(gamma_w H), 1: the way of the slow wave against that of diffusion, with k, the
  /// skeleton's modulus M, the saturated density rho and the depth H of the wet ground. Settlement errs by
  /// about 0.8 Pi^1.5 of what the rest adds.
  double slow_wave = 0.0;
  double permeability = 0.0; ///< F k, m/s
  double ringing = 0.0;      ///< T_u = 4 H/c_u, s: the period in which pressure rings

  /// Of the settlement that the rest adds, 1.
  double settlement_error() const;
};

/// Nothing where there is no rest, no time factor, or no water that flows.
std::optional<FastRest> fast_rest(const Case& scene);

} // namespace tremolo::scene
