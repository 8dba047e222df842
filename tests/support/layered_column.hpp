#pragma once

// Exact response of a damped, layered column of scalar waves on an elastic half-space to an incident Ricker
// velocity pulse: the second method that columns are compared with.
//
// Per frequency, exp(i w t): E* = E (1 + i w beta), rho* = rho (1 + alpha/(i w)), k = w sqrt(rho*/E*). At a
// depth z below the top of a layer, with v_0 and tau_0 there,
//
//     v = v_0 cos kz + B sin kz,   tau = E* k/(i w) (v_0 sin kz - B cos kz),   B = -i w tau_0/(E* k).
//
// tau = 0 at the surface; at the base the half-space's traction, tau = Z (v - 2 v_incident), Z = rho c.
// The time series are direct Fourier sums with a period long enough for the response to die out.

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

namespace tremolo::testing {

struct ScalarLayer {
  double thickness = 0.0; ///< m
  double density = 0.0;   ///< kg/m3
  double modulus = 0.0;   ///< Pa
  double alpha = 0.0;     ///< 1/s
  double beta = 0.0;      ///< s
};

class LayeredColumn {
public:
  struct Motion {
    double velocity = 0.0, acceleration = 0.0, stress = 0.0, stress_rate = 0.0;
  };

  /// Layers from the surface down; pulse of `frequency` (Hz) at `time` (s), 1 m/s, at the level of the base.
  LayeredColumn(std::vector<ScalarLayer> layers, double base_impedance, double frequency, double time)
      : layers_(std::move(layers)), impedance_(base_impedance), frequency_(frequency), time_(time) {}

  /// At `depth` (m) below the surface, at all `times` (s).
  std::vector<Motion> at(double depth, const std::vector<double>& times) const {
    std::vector<Motion> motions(times.size());
    constexpr double period = 60.0;
    const auto count = static_cast<std::size_t>(8.0 * frequency_ * period);
    for (std::size_t n = 1; n < count; ++n) {
      const double f = static_cast<double>(n) / period;
      const double w = 2.0 * std::numbers::pi * f;
      const auto [v, tau] = transfer(depth, w);
      const double ratio = f / frequency_;
      const double spectrum =
          2.0 / std::sqrt(std::numbers::pi) * ratio * ratio * std::exp(-ratio * ratio) / frequency_;
      for (std::size_t i = 0; i < times.size(); ++i) {
        const Complex wave = std::polar(2.0 / period * spectrum, w * (times[i] - time_));
        motions[i].velocity += (wave * v).real();
        motions[i].acceleration += (Complex(0.0, w) * wave * v).real();
        motions[i].stress += (wave * tau).real();
        motions[i].stress_rate += (Complex(0.0, w) * wave * tau).real();
      }
    }
    return motions;
  }

private:
  using Complex = std::complex<double>;
  struct State {
    Complex velocity, stress;
  };

  static State below(const ScalarLayer& layer, State top, double z, double w) {
    const Complex iw(0.0, w);
    const Complex modulus = layer.modulus * (1.0 + iw * layer.beta);
    const Complex k = w * std::sqrt(layer.density * (1.0 + layer.alpha / iw) / modulus);
    const Complex b = -iw * top.stress / (modulus * k);
    return {top.velocity * std::cos(k * z) + b * std::sin(k * z),
            modulus * k / iw * (top.velocity * std::sin(k * z) - b * std::cos(k * z))};
  }

  /// Velocity and stress at a depth per unit incident velocity.
  State transfer(double depth, double w) const {
    State state = {1.0, 0.0};
    State at_depth = state;
    double top = 0.0;
    for (const ScalarLayer& layer : layers_) {
      if (depth >= top) {
        at_depth = below(layer, state, std::min(depth - top, layer.thickness), w);
      }
      state = below(layer, state, layer.thickness, w);
      top += layer.thickness;
    }
    const Complex incident = 0.5 * (state.velocity - state.stress / impedance_);
    return {at_depth.velocity / incident, at_depth.stress / incident};
  }

  std::vector<ScalarLayer> layers_;
  double impedance_;
  double frequency_;
  double time_;
};

} // namespace tremolo::testing
