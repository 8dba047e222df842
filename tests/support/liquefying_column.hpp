#pragma once

// The columns of $TREMOLO_REFERENCE/columns_liquefaction: 10 m of saturated sand, water table at the surface,
// rigid impervious base shaken by a(t) = A w(t) sin(2 pi t) for 15 s; pore pressure and displacement of u-p
// finite elements with the same laws (OpenSees, SSPquadUP). This is the same column with soil and water of
// velocities of their own.

#include "freefield/twophase/two_phase_column.hpp"
#include "materials/sand/pdmy03/pdmy03.hpp"
#include "materials/sand/pm4sand/pm4sand.hpp"
#include "tests/support/reference_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace tremolo::freefield::testing {

/// A run of the reference: sand, permeability and end.
struct LiquefyingSand {
  std::string name;
  materials::Law law;
  double void_ratio = 0.0;
  double permeability = 0.0; ///< m/s
  double end = 25.0;         ///< s
  double shaking = 0.981;    ///< amplitude of the base, m/s2
};

inline LiquefyingSand pm4sand_column(std::string name, double relative_density, double G_o, double h_po,
                                     double permeability, double end = 25.0) {
  const double e = 0.8 - 0.3 * relative_density;
  const materials::PoreSpace pores{
      .porosity = materials::porosity_of(e), .grain_density = 2650.0, .permeability = permeability};
  auto law = materials::pm4sand({.density = materials::saturated_density(pores, {}),
                                 .relative_density = relative_density,
                                 .G_o = G_o,
                                 .h_po = h_po});
  law.elastic.at_rest = 0.5; // gravity was put on with nu = 1/3
  return {std::move(name), law, e, permeability, end};
}

inline LiquefyingSand pdmy03_column(std::string name) {
  return {std::move(name), materials::pdmy03({.relative_density = 0.57}), 2.0 / 3.0, 1e-4};
}

/// Velocity of the base: the integral of a(t), by Simpson's rule in intervals of a millisecond.
class BaseShaking {
public:
  explicit BaseShaking(double amplitude) : amplitude_(amplitude), velocity_(intervals + 1) {
    for (std::size_t i = 0; i < intervals; ++i) {
      const double t = static_cast<double>(i) * interval;
      velocity_[i + 1] = velocity_[i] + interval / 6.0 *
                                            (acceleration(t) + 4.0 * acceleration(t + 0.5 * interval) +
                                             acceleration(t + interval));
    }
  }

  Velocity operator()(double time) const {
    if (time <= 0.0)
      return {};
    const double position = std::min(time / interval, static_cast<double>(intervals));
    const auto i = std::min(static_cast<std::size_t>(position), intervals - 1);
    return {std::lerp(velocity_[i], velocity_[i + 1], position - static_cast<double>(i)), 0.0};
  }

private:
  static constexpr double interval = 1e-3;
  static constexpr std::size_t intervals = 15000;

  double acceleration(double t) const {
    using std::numbers::pi;
    const double rise = t < 2.0 ? std::sin(pi * t / 4.0) : t > 13.0 ? std::sin(pi * (15.0 - t) / 4.0) : 1.0;
    return amplitude_ * rise * rise * std::sin(2.0 * pi * t);
  }

  double amplitude_;
  std::vector<double> velocity_;
};

inline constexpr std::array depths = {1.0, 2.5, 5.0, 7.5, 9.5}; // m

/// Histories of r_u at the depths, and of the settlement.
struct LiquefactionHistory {
  std::vector<double> time;                             ///< s
  std::array<std::vector<double>, depths.size()> ratio; ///< r_u
  std::vector<double> settlement;                       ///< m

  double ratio_at(std::size_t depth, double t) const { return at(ratio[depth], t); }
  double settlement_at(double t) const { return at(settlement, t); }

  /// The first time at which the centred 1-s mean of r_u at a depth reaches a level; infinite where never, of
  /// the first 25 s with rows every 0.02 s.
  double time_of(std::size_t depth, double level) const {
    const std::size_t rows = rows_until(25.0);
    constexpr std::size_t half = 25;
    for (std::size_t i = 0; i < rows; ++i) {
      const std::size_t first = i < half ? 0 : i - half;
      const std::size_t last = std::min(i + half + 1, rows);
      double sum = 0.0;
      for (std::size_t k = first; k < last; ++k)
        sum += ratio[depth][k];
      if (sum / static_cast<double>(last - first) >= level)
        return time[i];
    }
    return std::numeric_limits<double>::infinity();
  }

  /// The mean of r_u between two times.
  double mean(std::size_t depth, double from, double to) const {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < time.size(); ++i)
      if (time[i] >= from - 1e-6 && time[i] <= to + 1e-6) {
        sum += ratio[depth][i];
        ++count;
      }
    return sum / count;
  }

private:
  std::size_t rows_until(double end) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(time, end + 1e-6) - time.begin());
  }
  double at(const std::vector<double>& values, double t) const {
    const auto next = static_cast<std::size_t>(std::ranges::lower_bound(time, t - 1e-6) - time.begin());
    if (next == 0 || next >= time.size())
      return values[std::min(next, time.size() - 1)];
    const double s = (t - time[next - 1]) / (time[next] - time[next - 1]);
    return std::lerp(values[next - 1], values[next], s);
  }
};

/// Root mean square until a time and over all depths by which r_u differs.
inline double apart(const LiquefactionHistory& a, const LiquefactionHistory& b, double until) {
  double squares = 0.0;
  int count = 0;
  for (; 0.02 * count < until; ++count)
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const double difference = a.ratio_at(i, 0.02 * count) - b.ratio_at(i, 0.02 * count);
      squares += difference * difference / depths.size();
    }
  return std::sqrt(squares / count);
}

/// Sand that gravity has strained elastically, with G_o p_A and nu = 1/3: the reference keeps that strain in
/// the void ratio, PDMY03 in its state. At 10 m it is 0.2 % of D_R.
/// @param vertical  effective stress, Pa, compression positive
inline materials::Law strained_by_gravity(materials::Law law, double vertical) {
  if (auto* const sand = std::get_if<materials::Pm4Sand>(&law))
    sand->relative_density += sand->density_rate * vertical / (4.0 * sand->G_o * sand->p_A);
  return law;
}

/// 10 m of a saturated sand, 0.5 % of damping at 5 Hz.
inline Profile liquefying_profile(const LiquefyingSand& sand) {
  const materials::PoreSpace pores{.porosity = materials::porosity_of(sand.void_ratio),
                                   .grain_density = 2650.0,
                                   .permeability = sand.permeability};
  constexpr double thickness = 2.0; // m, of layers of one density
  Layer layer = layer_of(thickness, sand.law, 0.005);
  layer.soil.density = materials::saturated_density(pores, {});
  std::visit([&](auto& law) { law.elastic.density = layer.soil.density; }, *layer.law);
  layer.pores = pores;
  Profile profile{0.0, {}, materials::Elasticity::from_wave_speeds(2200.0, 760.0, 1900.0)};
  const double weight = materials::buoyant_density(pores, {}) * 9.81;
  const materials::Law unstrained = *layer.law;
  for (double depth = 0.5 * thickness; depth < 10.0; depth += thickness) {
    layer.law = strained_by_gravity(unstrained, weight * depth);
    profile.layers.push_back(layer);
  }
  profile.gravity = 9.81;
  profile.water = WaterTable{0.0, {}};
  return profile;
}

inline TwoPhaseSettings liquefying_settings(double element_size, double dt) {
  return {.max_element_size = element_size,
          .time_step = dt,
          .damping = KelvinVoigtDamping{5.0},
          .base = BaseKind::rigid};
}

/// A rest with a time factor (1) from a time (s) on.
inline materials::SoilClock rest_from(double time, double factor = 1.0) {
  return materials::SoilClock({{time}, {1e4, factor}});
}

/// Our column, elements of 0.5 m as the reference's.
/// @param clock  of the soil, which without one is shaken to the end
/// @param again  times at which the base is shaken once more, s
inline LiquefactionHistory computed(const LiquefyingSand& sand, double element_size = 0.5, double dt = 2e-4,
                                    const materials::SoilClock& clock = {},
                                    const std::vector<double>& again = {}) {
  const Profile profile = liquefying_profile(sand);
  TwoPhaseSettings settings = liquefying_settings(element_size, dt);
  settings.clock = clock;
  const BaseShaking once(sand.shaking);
  const auto base = [&](double time) {
    Velocity velocity = once(time);
    for (const double start : again)
      velocity.x += once(time - start).x;
    return velocity;
  };
  TwoPhaseColumn column(profile, settings, base);
  std::vector<double> levels = {0.0};
  for (const double depth : depths)
    levels.push_back(-depth);
  std::vector<ColumnSample> samples(levels.size());
  const double weight = materials::buoyant_density(*profile.layers[0].pores, {}) * 9.81;
  LiquefactionHistory history;
  long row = 0;
  const auto next = [&] {
    return row <= 1250 ? 0.02 * static_cast<double>(row) : 25.0 + 0.5 * static_cast<double>(row - 1250);
  };
  while (next() <= sand.end + 1e-6) {
    while (column.time() < next() - 0.5 * dt)
      column.step();
    column.sample(levels, samples);
    history.time.push_back(next());
    history.settlement.push_back(-samples[0].uy);
    for (std::size_t i = 0; i < depths.size(); ++i)
      history.ratio[i].push_back(samples[i + 1].pore_pressure / (weight * depths[i]));
    ++row;
  }
  return history;
}

} // namespace tremolo::freefield::testing
