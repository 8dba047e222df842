#include "wavefield/layers/transfer.hpp"

#include "base/require.hpp"
#include "wavefield/layers/field_spectra.hpp"
#include "wavefield/layers/reflectivity.hpp"

#include <cmath>
#include <numbers>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;

/// Amplitude of the waves that `reflectivity` has solved for at s, at y relative to the top of a medium (y <=
/// 0, m).
Amplitude at_level(const Reflectivity& reflectivity, WaveType wave_type, std::size_t medium,
                   const LayerAmplitudes& amplitudes, double thickness, double y, Complex s) {
  const WaveBasis& basis = reflectivity.basis(medium);
  Eigen::Vector2cd up = amplitudes.up;
  Eigen::Vector2cd down = amplitudes.down;
  for (std::size_t wave = 0; wave < 2; ++wave) {
    const auto i = static_cast<Eigen::Index>(wave);
    up[i] *= std::exp(-s * basis.q[wave] * (y + thickness));
    down[i] *= std::exp(s * basis.q[wave] * y);
  }
  Eigen::Vector2cd velocity = basis.up.topRows<2>() * up + basis.down.topRows<2>() * down;
  velocity[wave_type == WaveType::SV ? 0 : 1] += amplitudes.carried;
  return {velocity[0], velocity[1]};
}

void require_frequencies(std::span<const double> frequencies_hz) {
  for (const double frequency : frequencies_hz)
    require_positive("frequency of a transfer function", frequency, "Hz");
}

} // namespace

std::vector<std::vector<Amplitude>> transfer(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                             std::span<const double> frequencies_hz,
                                             std::span<const double> depths) {
  require_frequencies(frequencies_hz);
  for (const double depth : depths) {
    require(depth >= 0.0 && std::isfinite(depth), "depth of a transfer function", depth,
            "at least 0 m and finite");
  }
  Reflectivity reflectivity(profile, wave, angle_rad);
  const FieldSetup setup{.profile = profile, .incidence = {}, .signal = {}}; // surface at y = 0
  std::vector<std::vector<Amplitude>> spectra;
  for (const double frequency : frequencies_hz) {
    const Complex s(0.0, 2.0 * std::numbers::pi * frequency);
    const auto& amplitudes = reflectivity.solve(s);
    auto& row = spectra.emplace_back();
    for (const double depth : depths) {
      const std::size_t medium = setup.medium_at({0.0, -depth});
      const double thickness = medium < profile.layers.size() ? profile.layers[medium].thickness : 0.0;
      row.push_back(at_level(reflectivity, wave, medium, amplitudes[medium], thickness,
                             -depth - setup.top_of(medium), s));
    }
  }
  return spectra;
}

Amplitude outcrop(const HalfSpace& half_space, WaveType wave, double angle_rad) {
  Reflectivity reflectivity({.half_space = half_space}, wave, angle_rad);
  return at_level(reflectivity, wave, 0, reflectivity.solve(0.0).front(), 0.0, 0.0, 0.0);
}

std::vector<SurfaceTransfer> surface_transfer(const LayeredHalfSpace& profile, WaveType wave,
                                              double angle_rad, std::span<const double> frequencies_hz) {
  const std::array<double, 2> depths{0.0, profile.thickness()};
  const auto component = wave == WaveType::SV ? &Amplitude::ux : &Amplitude::uy;
  const Amplitude bare = outcrop(profile.half_space, wave, angle_rad);
  const auto spectra = transfer(profile, wave, angle_rad, frequencies_hz, depths);
  std::vector<SurfaceTransfer> result;
  for (std::size_t i = 0; i < spectra.size(); ++i) {
    const Amplitude& surface = spectra[i][0];
    const Amplitude& within = spectra[i][1];
    result.push_back({.frequency_hz = frequencies_hz[i],
                      .surface = surface,
                      .within = within,
                      .to_outcrop = surface.*component / (bare.*component),
                      .to_within = surface.*component / (within.*component)});
  }
  return result;
}

} // namespace tremolo::wavefield
