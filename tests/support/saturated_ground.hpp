#pragma once

// Saturated elastic ground that the tests of the two-phase column share: n = 0.4, grains of 2650 kg/m3, water
// of 1000 kg/m3 and 2.2 GPa, g = 9.81 m/s2, on a rigid base, drained at its surface.

#include "freefield/twophase/two_phase_column.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::freefield::testing {

inline constexpr double gravity = 9.81;       // m/s2
inline constexpr materials::PoreFluid water;  // 1000 kg/m3, 2.2 GPa
inline constexpr double unit_weight = 9810.0; // of water, N/m3

/// A saturated elastic layer.
/// @param modulus  M = K + 4/3 G, Pa; nu = 0.25
inline Layer wet_layer(double thickness, double modulus, double permeability, double porosity = 0.4) {
  const materials::PoreSpace pores{
      .porosity = porosity, .grain_density = 2650.0, .permeability = permeability};
  constexpr double poisson = 0.25;
  const double young = modulus * (1.0 + poisson) * (1.0 - 2.0 * poisson) / (1.0 - poisson);
  Layer layer{.thickness = thickness,
              .soil = {materials::saturated_density(pores, water), young, poisson},
              .damping_ratio = 0.0};
  layer.pores = pores;
  return layer;
}

/// Layers from the top down, water table and surface at y = 0.
inline Profile wet_profile(std::vector<Layer> layers) {
  Profile profile{0.0, std::move(layers), materials::Elasticity::from_wave_speeds(2200.0, 760.0, 1900.0)};
  profile.gravity = gravity;
  profile.water = WaterTable{0.0, water};
  return profile;
}

inline Velocity at_rest(double /*time*/) {
  return {};
}

/// Settings over a rigid base, at a share of the stability limit.
inline TwoPhaseSettings wet_settings(const Profile& profile, double element_size, double share = 0.8) {
  return {.max_element_size = element_size,
          .time_step = share * two_phase_step_limit(profile, element_size, Damping{}),
          .base = BaseKind::rigid};
}

/// first, first + step, ... up to `last`.
inline std::vector<double> evenly(double first, double last, double step) {
  std::vector<double> values;
  const auto count = static_cast<std::size_t>((last - first) / step + 1e-9) + 1;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(first + static_cast<double>(i) * step);
  return values;
}

inline void march(TwoPhaseColumn& column, double until) {
  while (column.time() < until - 0.5 * column.time_step())
    column.step();
}

inline ColumnSample sample_at(const TwoPhaseColumn& column, double y) {
  const double level[] = {y};
  ColumnSample sample[1];
  column.sample(level, sample);
  return sample[0];
}

} // namespace tremolo::freefield::testing
