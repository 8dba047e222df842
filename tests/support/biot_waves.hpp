#pragma once

// The two compression waves of saturated elastic ground at one frequency, e^{i(wt - ky)}: k and (v_s, v_f)
// from
//
//     [k^2 K - w^2 R] u = 0,  K the matrix of stiffness, R masses and drag (Biot 1956; Verruijt 2010).

#include "tests/support/saturated_ground.hpp"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace tremolo::freefield::testing {

struct BiotWave {
  std::complex<double> number; ///< k, 1/m, Re k > 0
  Eigen::Vector2cd mode;       ///< of solid and fluid
  double frequency = 0.0;      ///< Hz

  double speed() const { return 2.0 * std::numbers::pi * frequency / number.real(); }
  /// Over which the amplitude falls by e, m.
  double decay_length() const { return 1.0 / std::abs(number.imag()); }
  /// What a pore pressure is made of: p = -Q [(1-n) u_s' + n u_f'], over u', Pa.
  std::complex<double> pressure(double porosity, double stiffness) const {
    return -stiffness * ((1.0 - porosity) * mode(0) + porosity * mode(1));
  }
};

/// The fast wave and the slow one in ground of wet_layer().
inline std::array<BiotWave, 2> biot_waves(double modulus, double permeability, double frequency) {
  using namespace std::complex_literals;
  const auto pores = *wet_layer(1.0, modulus, permeability).pores;
  const double n = pores.porosity, q = materials::pore_stiffness(pores, water);
  const double ms = materials::dry_density(pores), mf = n * water.density;
  const double w = 2.0 * std::numbers::pi * frequency;
  const std::complex<double> drag = n * n * unit_weight / permeability / (1i * w);
  Eigen::Matrix2cd stiffness, inertia;
  stiffness << modulus + q * (1 - n) * (1 - n), q * n * (1 - n), q * n * (1 - n), q * n * n;
  inertia << ms + drag, -drag, -drag, mf + drag;
  const Eigen::Matrix2cd reduced = stiffness.inverse() * inertia * (w * w);
  const Eigen::ComplexEigenSolver<Eigen::Matrix2cd> solver(reduced);
  std::array<BiotWave, 2> waves;
  for (int m = 0; m < 2; ++m)
    waves[m] = {std::sqrt(solver.eigenvalues()(m)), solver.eigenvectors().col(m), frequency};
  if (waves[0].speed() < waves[1].speed())
    std::swap(waves[0], waves[1]);
  return waves;
}

} // namespace tremolo::freefield::testing
