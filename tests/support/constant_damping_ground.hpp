#pragma once

// Layers with constant damping on rock, under a pulse: columns in time against the exact field of the
// frequency domain, in which the same mechanisms are a complex modulus.

#include "freefield/column.hpp"
#include "freefield/profile.hpp"
#include "wavefield/layers/layered_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

namespace tremolo::testing {

/// The wave field's layers of a profile in one material, water with the grains.
inline wavefield::LayeredHalfSpace damped_layers(const freefield::Profile& profile,
                                                 const wavefield::Damping& damping) {
  const materials::Elasticity& base = profile.half_space;
  wavefield::LayeredHalfSpace layered{
      .half_space = {.density = base.density, .vs = base.s_wave_speed(), .vp = base.p_wave_speed()},
      .damping = damping};
  for (const freefield::Layer& layer : profile.layers) {
    const double water = layer.pores ? materials::pore_stiffness(*layer.pores, profile.water->fluid) : 0.0;
    const double p_modulus = layer.soil.p_modulus() + water;
    layered.layers.push_back(
        {.thickness = layer.thickness,
         .density = layer.soil.density,
         .vs = layer.soil.s_wave_speed(),
         .vp = std::sqrt(p_modulus / layer.soil.density),
         .damping = layer.damping_ratio,
         .relaxing_share_p = layer.pores ? layer.soil.shear_modulus() / p_modulus : 1.0});
  }
  return layered;
}

/// An incident Ricker pulse.
struct IncidentPulse {
  wavefield::WaveType type = wavefield::WaveType::SV;
  double angle_deg = 0.0;
  double frequency = 4.0;  ///< Hz
  double amplitude = 1e-6; ///< m/s: elements keep their length

  double angle() const { return angle_deg * std::numbers::pi / 180.0; }
  wavefield::Signal signal() const { return wavefield::ricker(frequency, 1.0, amplitude); }
  freefield::InputVelocity input() const {
    return [pulse = signal(), sine = std::sin(angle()), cosine = std::cos(angle()), wave = type](double t) {
      const double v = t < pulse.begin || t > pulse.end ? 0.0 : pulse.velocity(t);
      return wave == wavefield::WaveType::SV ? freefield::Velocity{cosine * v, -sine * v}
                                             : freefield::Velocity{sine * v, cosine * v};
    };
  }
};

/// vx, vy, sxx, syy, sxy
using ColumnErrors = std::array<double, 5>;
constexpr std::array<const char*, 5> column_quantities = {"vx", "vy", "sxx", "syy", "sxy"};

/// Largest errors of a column over levels and 2.5 s, relative to the peaks; of what stays zero, zero.
inline ColumnErrors errors_of(freefield::Column& column, const wavefield::LayeredHalfSpace& layers,
                              const IncidentPulse& pulse, const std::vector<double>& levels) {
  constexpr double interval = 0.01;
  constexpr std::size_t intervals = 250;
  const wavefield::LayeredField field(layers, {pulse.type, pulse.angle(), 0.0, column.base_level()},
                                      column.surface_level(), pulse.signal());
  std::vector<wavefield::Point> points;
  for (const double y : levels)
    points.push_back({.x = 0.0, .y = y});
  const auto exact = field.sample(points, {interval, interval, intervals});
  ColumnErrors error{}, peak{};
  std::vector<freefield::ColumnSample> samples(levels.size());
  for (std::size_t i = 0; i < intervals; ++i) {
    const double time = interval * static_cast<double>(i + 1);
    while (column.time() < time - 1e-3 * column.time_step())
      column.step();
    column.sample(levels, samples);
    for (std::size_t level = 0; level < levels.size(); ++level) {
      const auto& s = samples[level];
      const auto& h = exact[level];
      const ColumnErrors computed = {s.vx, s.vy, s.sxx, s.syy, s.sxy};
      const ColumnErrors expected = {h.vx[i], h.vy[i], h.sxx[i], h.syy[i], h.sxy[i]};
      for (std::size_t q = 0; q < error.size(); ++q) {
        error[q] = std::max(error[q], std::abs(computed[q] - expected[q]));
        peak[q] = std::max(peak[q], std::abs(expected[q]));
      }
    }
  }
  for (std::size_t q = 0; q < error.size(); ++q)
    error[q] = peak[q] < 1e-9 * *std::ranges::max_element(peak) ? 0.0 : error[q] / peak[q];
  return error;
}

} // namespace tremolo::testing
