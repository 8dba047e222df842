#pragma once

// The ground and the motion by which speeds of columns are compared.

#include "freefield/column.hpp"
#include "freefield/profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tremolo::freefield {

/// 100 m of soil whose wave speed grows with depth, ten layers of twenty elements of 0.5 m.
inline Profile mkz_profile() {
  using materials::Elasticity;
  Profile profile{.half_space = Elasticity::from_wave_speeds(2200.0, 760.0, 1520.0)};
  for (int i = 0; i < 10; ++i) {
    const double vs = 180.0 + 20.0 * i;
    const Elasticity soil = Elasticity::from_wave_speeds(1900.0, vs, 2.0 * vs);
    profile.layers.push_back(
        layer_of(10.0, materials::MasingShear{.elastic = soil, .reference_strain = 6e-4, .exponent = 0.919}));
  }
  return profile;
}

/// 41 s of strong shaking along an SV wave, linear between the samples of a record of 5 ms.
/// @param peak       m/s, at most
/// @param incidence  from the vertical, rad
inline InputVelocity strong_shaking(double peak, double incidence = 0.0) {
  constexpr double record_step = 5e-3;
  std::vector<double> samples;
  for (int i = 0; i * record_step <= 41.0; ++i) {
    const double t = i * record_step;
    const double envelope = peak * std::pow(t / 8.0, 2) * std::exp(2.0 * (1.0 - t / 8.0));
    samples.push_back(envelope * (std::sin(9.0 * t) + std::sin(23.0 * t + 1.0) + std::sin(41.0 * t)) / 3.0);
  }
  return [samples, c = std::cos(incidence), s = std::sin(incidence)](double t) {
    const double position = std::clamp(t / record_step, 0.0, static_cast<double>(samples.size() - 2));
    const auto i = static_cast<std::size_t>(position);
    const double v = std::lerp(samples[i], samples[i + 1], position - static_cast<double>(i));
    return Velocity{v * c, -v * s};
  };
}

} // namespace tremolo::freefield
