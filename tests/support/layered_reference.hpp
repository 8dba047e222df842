#pragma once

// The three-layer profile of the reference files layered3_*, and how histories compare with their rows.

#include "tests/support/reference_table.hpp"
#include "wavefield/layers/layered_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace tremolo::testing {

inline double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

/// 6 m and 14 m of soil on a half-space; with the model `none` without damping.
inline wavefield::LayeredHalfSpace layered3(const wavefield::Damping& damping) {
  const double on = damping.model == wavefield::DampingModel::none ? 0.0 : 1.0;
  return {.layers = {{.thickness = 6.0, .density = 1700.0, .vs = 120.0, .vp = 300.0, .damping = 0.05 * on},
                     {.thickness = 14.0, .density = 1850.0, .vs = 220.0, .vp = 500.0, .damping = 0.03 * on}},
          .half_space = {2100.0, 500.0, 1000.0},
          .half_space_damping = 0.01 * on,
          .damping = damping};
}

/// Largest error of displacement, velocity and stress, each relative to the largest value of its kind.
struct HistoryErrors {
  double displacement = 0.0, velocity = 0.0, stress = 0.0;
};

/// The field against rows t,x,y,ux,uy,vx,vy,sxx,syy,sxy, all times of a point together.
inline HistoryErrors errors(const wavefield::LayeredField& field,
                            const std::vector<std::vector<double>>& rows) {
  std::size_t times = 1;
  while (times < rows.size() && rows[times][0] > rows[times - 1][0]) {
    ++times;
  }
  std::vector<wavefield::Point> points;
  for (std::size_t row = 0; row < rows.size(); row += times) {
    points.push_back({rows[row][1], rows[row][2]});
  }
  const double last = rows[times - 1][0];
  const wavefield::TimeGrid grid{rows[0][0], (last - rows[0][0]) / static_cast<double>(times - 1), times};
  const auto histories = field.sample(points, grid);

  constexpr std::array<std::size_t, 7> kind_of = {0, 0, 1, 1, 2, 2, 2};
  std::array<double, 3> peak{};
  std::array<double, 3> error{};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const wavefield::History& h = histories[row / times];
    const std::array<const std::vector<double>*, 7> computed = {&h.ux,  &h.uy,  &h.vx, &h.vy,
                                                                &h.sxx, &h.syy, &h.sxy};
    for (std::size_t q = 0; q < computed.size(); ++q) {
      const double exact = rows[row][3 + q];
      peak[kind_of[q]] = std::max(peak[kind_of[q]], std::abs(exact));
      error[kind_of[q]] = std::max(error[kind_of[q]], std::abs((*computed[q])[row % times] - exact));
    }
  }
  return {error[0] / peak[0], error[1] / peak[1], error[2] / peak[2]};
}

} // namespace tremolo::testing
