// Elastic soil in a container, L wide and H deep, that is shaken along x: rough base, smooth walls. The
// motion u relative to the container is periodic in 2 L, odd for u_x and even for u_y, and inertia -rho A(t)
// is a square wave:
//
//     u_x = sum U_n(y) sin(k x),   u_y = sum V_n(y) cos(k x),   k = n pi/L, n odd,   A_n = 4 A/(n pi).
//
// After a Laplace transform in time each n is a system of two ordinary equations in y, solved by
//
//     U = -A_n/(s^2 + c_p^2 k^2) - k (a e^(p y) + b e^(-p y)) + q (c e^(q y) - d e^(-q y)),
//     V = p (a e^(p y) - b e^(-p y)) - k (c e^(q y) + d e^(-q y)),
//     p^2 = k^2 + s^2/c_p^2,   q^2 = k^2 + s^2/c_s^2,
//
// with U = V = 0 at the base and no traction at the surface (Wood 1973, Earthquake-induced soil pressures on
// structures, Caltech EERL 73-05, has the walls' pressure for slow motions). The way back to time is a
// Fourier sum along s = s_0 + i w.

#include "tests/verification/mpm_domain/rigid_base/shaken_box.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using Complex = std::complex<double>;
using test_support::BasePulse;
using test_support::ShakenBox;

constexpr double width = 24.0; // m
constexpr double depth = 12.0; // m
constexpr double end = 0.8;    // s
constexpr double period = 1.6; // of the Fourier sum, s
constexpr double s0 = 6.0;     // 1/s: what comes round again has faded by exp(-s0 period)
constexpr int terms = 25;      // n = 1, 3, ..., 49
constexpr int frequencies = 24;

/// The Laplace transform of V at s: the pulse is smooth and zero at both ends.
Complex transformed(const BasePulse& pulse, Complex s) {
  constexpr int samples = 4000;
  constexpr double dt = 0.8 / samples;
  Complex sum = 0.0;
  for (int i = 0; i < samples; ++i)
    sum += pulse(i * dt) * std::exp(-s * (i * dt)) * dt;
  return sum;
}

/// U and V of one n at one s for a base acceleration of 1.
class Mode {
public:
  Mode(const materials::Elasticity& soil, Complex s, double k, double share) : k_(k) {
    const double cp = soil.p_wave_speed();
    const double cs = soil.s_wave_speed();
    const double mu = soil.density * cs * cs;
    const double modulus = soil.density * cp * cp; // lambda + 2 mu
    const double lambda = modulus - 2.0 * mu;
    p_ = std::sqrt(k * k + s * s / (cp * cp));
    q_ = std::sqrt(k * k + s * s / (cs * cs));
    inertia_ = -share / (s * s + cp * cp * k * k);
    // Growing waves are scaled by their value at the surface.
    const Complex ep = std::exp(-p_ * depth);
    const Complex eq = std::exp(-q_ * depth);
    Eigen::Matrix4cd m;
    m.row(0) << -k * ep, -k, q_ * eq, -q_; // U, base
    m.row(1) << p_ * ep, -p_, -k * eq, -k; // V, base
    const Complex shear_p = -2.0 * k * p_; // U' - k V
    const Complex shear_q = q_ * q_ + k * k;
    m.row(2) << shear_p, -shear_p * ep, shear_q, shear_q * eq;
    const Complex normal_p = modulus * p_ * p_ - lambda * k * k; // (lambda + 2 mu) V' + lambda k U
    const Complex normal_q = -2.0 * mu * k * q_;
    m.row(3) << normal_p, normal_p * ep, normal_q, -normal_q * eq;
    const Eigen::Vector4cd right(-inertia_, 0.0, 0.0, -lambda * k * inertia_);
    waves_ = m.fullPivLu().solve(right);
  }

  std::array<Complex, 2> at(double y) const {
    const Complex a = waves_[0] * std::exp(p_ * (y - depth));
    const Complex b = waves_[1] * std::exp(-p_ * y);
    const Complex c = waves_[2] * std::exp(q_ * (y - depth));
    const Complex d = waves_[3] * std::exp(-q_ * y);
    return {inertia_ - k_ * (a + b) + q_ * (c - d), p_ * (a - b) - k_ * (c + d)};
  }

private:
  double k_;
  Complex p_, q_, inertia_;
  Eigen::Vector4cd waves_;
};

/// Velocity relative to the container at a place, by frequency.
class ExactContainer {
public:
  ExactContainer(const materials::Elasticity& soil, const BasePulse& pulse) {
    for (int w = 0; w < frequencies; ++w) {
      const Complex s{s0, 2.0 * std::numbers::pi * w / period};
      velocity_.push_back(transformed(pulse, s));
      for (int n = 0; n < terms; ++n) {
        const double k = (2 * n + 1) * std::numbers::pi / width;
        modes_.emplace_back(soil, s, k, 4.0 / ((2 * n + 1) * std::numbers::pi));
      }
    }
  }

  /// Its bins at a place, x from the left wall and y from the base.
  std::vector<std::array<Complex, 2>> bins(double x, double y) const {
    std::vector<std::array<Complex, 2>> result(frequencies);
    for (int w = 0; w < frequencies; ++w) {
      const Complex s{s0, 2.0 * std::numbers::pi * w / period};
      for (int n = 0; n < terms; ++n) {
        const double k = (2 * n + 1) * std::numbers::pi / width;
        const auto [u, v] = modes_[static_cast<std::size_t>(w * terms + n)].at(y);
        // A = s V, velocity = s u.
        const Complex factor = s * s * velocity_[static_cast<std::size_t>(w)];
        result[static_cast<std::size_t>(w)][0] += factor * u * std::sin(k * x);
        result[static_cast<std::size_t>(w)][1] += factor * v * std::cos(k * x);
      }
    }
    return result;
  }

  static eq6::Vector at(const std::vector<std::array<Complex, 2>>& bins, double time) {
    eq6::Vector v;
    for (int w = 0; w < frequencies; ++w) {
      const double twice = w == 0 ? 1.0 : 2.0;
      const Complex turn =
          std::polar(twice / period * std::exp(s0 * time), 2.0 * std::numbers::pi * w / period * time);
      v.x += (bins[static_cast<std::size_t>(w)][0] * turn).real();
      v.y += (bins[static_cast<std::size_t>(w)][1] * turn).real();
    }
    return v;
  }

private:
  std::vector<Complex> velocity_;
  std::vector<Mode> modes_; ///< [frequency][n]
};

/// The places of all particles have bins of their own, found when first asked for.
ShakenBox run(double h, const Scheme& scheme) {
  Spec spec = test_support::elastic_box(width, depth, h);
  spec.sides = Sides::container;
  spec.rigid_base = true;
  spec.scheme = scheme;
  const BasePulse pulse;
  const ExactContainer container(materials::elasticity(spec.soils.front().law), pulse);
  std::map<std::pair<double, double>, std::vector<std::array<Complex, 2>>> positions;
  return run_shaken_box(
      spec, pulse, {1.0, 0.0},
      [&](double x, double y, double time) {
        auto [position, is_new] = positions.try_emplace({x, y});
        if (is_new)
          position->second = container.bins(x, y + depth);
        return ExactContainer::at(position->second, time);
      },
      end);
}

TEST(Container, ShakesAsTheSeriesOfItsModes) {
  const ShakenBox coarse = run(1.0, {});
  const ShakenBox fine = run(0.5, {});
  std::printf("h = 1 m: %.2e, 0.5 m: %.2e; ledger %.1e\n", coarse.error, fine.error, fine.residual);
  EXPECT_GT(std::log2(coarse.error / fine.error), 1.8);
  EXPECT_LT(fine.error, 0.01);
  EXPECT_LT(fine.residual, 0.02);
}

} // namespace
} // namespace tremolo::mpm_domain
