#pragma once

// Exact response of a damped, layered column of scalar waves on an elastic half-space to an incident Ricker
// velocity pulse: the second method that columns are compared with.
//
// Per frequency, exp(i w t), of rho (dv/dt + alpha (v - v_ref)) = d tau/dy: E* = E (1 + i w beta), rho* = rho
// (1 + alpha/(i w)), k = w sqrt(rho*/E*). A layer that moves as one without stress has v = p = alpha v_ref/(i
// w
// + alpha). At a depth z below the top of a layer, with v_0 and tau_0 there,
//
//     v = p + (v_0 - p) cos kz + B sin kz,   tau = E* k/(i w) ((v_0 - p) sin kz - B cos kz),   B = -i w
//     tau_0/(E* k).
//
// tau = 0 at the surface; at the base the half-space's traction, tau = Z (v - 2 v_incident), Z = rho c. v_ref
// is the outcrop motion, 2 v_incident, at the bottom of the lowest layer with alpha: later than at the base
// by the time of the wave through the undamped layers between. Linear in (v_surface, v_incident): two
// solutions, (1, 0) and (0, 1), make v_incident = 1. The time series are direct Fourier sums with a period
// long enough for the response to die out.

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>
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

  static State below(const ScalarLayer& layer, State top, Complex reference, double z, double w) {
    const Complex iw(0.0, w);
    const Complex modulus = layer.modulus * (1.0 + iw * layer.beta);
    const Complex k = w * std::sqrt(layer.density * (1.0 + layer.alpha / iw) / modulus);
    const Complex b = -iw * top.stress / (modulus * k);
    const Complex p = layer.alpha * reference / (iw + layer.alpha);
    return {p + (top.velocity - p) * std::cos(k * z) + b * std::sin(k * z),
            modulus * k / iw * ((top.velocity - p) * std::sin(k * z) - b * std::cos(k * z))};
  }

  /// State at a depth and at the base under a surface that moves with v, with the outcrop motion v_ref.
  std::pair<State, State> column(Complex v, Complex reference, double depth, double w) const {
    State state = {v, 0.0};
    State at_depth = state;
    double top = 0.0;
    for (const ScalarLayer& layer : layers_) {
      if (depth >= top)
        at_depth = below(layer, state, reference, std::min(depth - top, layer.thickness), w);
      state = below(layer, state, reference, layer.thickness, w);
      top += layer.thickness;
    }
    return {at_depth, state};
  }

  /// From the base up to the lowest layer with alpha, s.
  double rise() const {
    double time = 0.0;
    for (auto layer = layers_.rbegin(); layer != layers_.rend() && layer->alpha == 0.0; ++layer)
      time += layer->thickness * std::sqrt(layer->density / layer->modulus);
    return time;
  }

  /// Velocity and stress at a depth per unit incident velocity.
  State transfer(double depth, double w) const {
    const auto [own, own_base] = column(1.0, 0.0, depth, w);
    const auto [led, led_base] = column(0.0, std::polar(2.0, -w * rise()), depth, w);
    const auto incident = [&](State base) { return 0.5 * (base.velocity - base.stress / impedance_); };
    const Complex surface = (1.0 - incident(led_base)) / incident(own_base);
    return {surface * own.velocity + led.velocity, surface * own.stress + led.stress};
  }

  std::vector<ScalarLayer> layers_;
  double impedance_;
  double frequency_;
  double time_;
};

} // namespace tremolo::testing
