#include "coupler/mapping/served_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tremolo::coupler {

namespace {

constexpr std::size_t rate = values_per_point / 2; ///< from a value to its time derivative
constexpr std::size_t vx = 0, vy = 1, sxx = 2, syy = 3, sxy = 4;

struct Sums {
  double left_over = 0.0;
  double differences = 0.0;
  double integrals = 0.0;

  [[nodiscard]] double defect() const {
    const double sides = std::max(differences, integrals);
    return sides > 0.0 ? std::sqrt(left_over / sides) : 0.0;
  }
};

/// Sums over steps and points of one direction.
struct MomentumSums {
  double acceleration_force = 0.0;
  double acceleration_square = 0.0;
  double force_square = 0.0;

  void add(double acceleration, double force) {
    acceleration_force += acceleration * force;
    acceleration_square += acceleration * acceleration;
    force_square += force * force;
  }
};
using Momentum = std::array<MomentumSums, 2>; ///< horizontal, vertical

/// Derivative at the middle of three points.
double slope(const std::array<double, 3>& y, double below, double at, double above) {
  const double h0 = y[1] - y[0];
  const double h1 = y[2] - y[1];
  return ((above - at) * h0 / h1 + (at - below) * h1 / h0) / (h0 + h1);
}

Momentum momentum(const ServedSeries& series) {
  const auto& y = series.field.y;
  const double p = series.field.slowness_x;
  Momentum sums;
  for (std::uint64_t n = 0; n < series.steps(); ++n)
    for (std::size_t j = 1; j + 1 < y.size(); ++j) {
      if (y[j] == y[j - 1] || y[j] == y[j + 1])
        continue;
      const double* at = series.values.data() + n * series.field.values_per_step() + j * values_per_point;
      const auto gradient = [&](std::size_t c) {
        return slope({y[j - 1], y[j], y[j + 1]}, *(at - values_per_point + c), at[c],
                     at[values_per_point + c]);
      };
      sums[0].add(at[vx + rate], -p * at[sxx + rate] + gradient(sxy));
      sums[1].add(at[vy + rate], -p * at[sxy + rate] + gradient(syy));
    }
  return sums;
}

} // namespace

Peaks peaks(const ServedSeries& series, std::uint64_t first, std::uint64_t last) {
  Peaks found;
  const std::size_t count = series.field.values_per_step();
  for (std::size_t i = first * count; i < (last + 1) * count; i += values_per_point)
    for (std::size_t c = 0; c < rate; ++c) {
      double& peak = c < sxx ? found.velocity : found.stress;
      peak = std::max(peak, std::abs(series.values[i + c]));
    }
  return found;
}

double rate_defect(const ServedSeries& series) {
  const std::size_t count = series.field.values_per_step();
  std::array<Sums, 2> sums; // velocity, stress
  for (std::size_t i = count; i + count < series.values.size(); i += values_per_point)
    for (std::size_t c = 0; c < rate; ++c) {
      const double* at = series.values.data() + i + c;
      const double difference = at[count] - *(at - count);
      const double integral =
          series.field.time_step / 3.0 * (*(at - count + rate) + 4.0 * at[rate] + at[count + rate]);
      Sums& sum = sums[c < sxx ? 0 : 1];
      sum.left_over += (difference - integral) * (difference - integral);
      sum.differences += difference * difference;
      sum.integrals += integral * integral;
    }
  return std::max(sums[0].defect(), sums[1].defect());
}

std::optional<double> density_from_momentum(const ServedSeries& series) {
  const Momentum sums = momentum(series);
  const double acceleration_square = sums[0].acceleration_square + sums[1].acceleration_square;
  if (acceleration_square == 0.0)
    return std::nullopt;
  return (sums[0].acceleration_force + sums[1].acceleration_force) / acceleration_square;
}

std::optional<MomentumFit> momentum_fit(const ServedSeries& series, Direction direction) {
  const auto [af, aa, ff] = momentum(series)[direction == Direction::horizontal ? 0 : 1];
  if (aa == 0.0)
    return std::nullopt;
  return MomentumFit{af / aa, ff > 0.0 ? std::sqrt(std::max(0.0, 1.0 - af * af / (aa * ff))) : 1.0};
}

} // namespace tremolo::coupler
