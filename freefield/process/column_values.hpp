#pragma once

#include "freefield/column.hpp"
#include "wavefield/signal/history.hpp"

#include <array>
#include <cstddef>

namespace tremolo::freefield {

/// Values of a point in the order in which a source sends and a recording stores them.
inline std::array<double, 10> served_values(const ColumnSample& s) {
  return {s.vx, s.vy, s.sxx, s.syy, s.sxy, s.vx_rate, s.vy_rate, s.sxx_rate, s.syy_rate, s.sxy_rate};
}

/// Velocity, stress and their rates of a plane-wave history at one of its times; displacement and strain stay
/// zero.
inline ColumnSample sample_at(const wavefield::History& h, std::size_t i) {
  return {.vx = h.vx[i],
          .vy = h.vy[i],
          .sxx = h.sxx[i],
          .syy = h.syy[i],
          .sxy = h.sxy[i],
          .vx_rate = h.vx_rate[i],
          .vy_rate = h.vy_rate[i],
          .sxx_rate = h.sxx_rate[i],
          .syy_rate = h.syy_rate[i],
          .sxy_rate = h.sxy_rate[i]};
}

} // namespace tremolo::freefield
