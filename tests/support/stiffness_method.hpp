#pragma once

// A second way to the displacements of a layered half-space, independent of the reflectivity recursion and of
// its polarisation vectors: the state (vx, vy, sxy, syy) of exp(-s p x) obeys the ordinary differential
// equation
//
//     vx' = s sxy / G + s p vy                 sxy' = rho s vx + s p sxx
//     vy' = s syy / M + s p lambda/M vx        syy' = rho s vy + s p sxy,
//
// sxx = lambda/M syy - p (M - lambda^2/M) vx
// (velocities are displacements times s), whose eigenvectors the computer finds. Two solvers stand on it: the
// layer stiffness matrices of Kausel and Roesset (1981, Bull. Seism. Soc. Am. 71), assembled and solved at
// once, with exponentials that never grow; and the textbook propagator matrices of Thomson (1950) and Haskell
// (1953), which fail where waves are evanescent.

#include "wavefield/layers/layered_half_space.hpp"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace tremolo::testing {

using Complex = std::complex<double>;

/// Eigenvectors of one medium, columns upgoing P, upgoing S, downgoing P, downgoing S, stresses over Z, and
/// the exponents -s q, -s q, +s q, +s q of y.
struct EigenWaves {
  Eigen::Matrix4cd vectors;
  Eigen::Vector4cd exponents;
};

inline EigenWaves eigen_waves(double density, const wavefield::ComplexModuli& moduli, double p, double z,
                              Complex s) {
  const Complex m = moduli.p_wave;
  const Complex g = moduli.shear;
  const Complex lambda = m - 2.0 * g;
  Eigen::Matrix4cd a = Eigen::Matrix4cd::Zero(); // over s
  a(0, 2) = z / g;
  a(0, 1) = p;
  a(1, 3) = z / m;
  a(1, 0) = p * lambda / m;
  a(2, 0) = (density - p * p * (m - lambda * lambda / m)) / z;
  a(2, 3) = p * lambda / m;
  a(3, 1) = density / z;
  a(3, 2) = p;
  const Eigen::ComplexEigenSolver<Eigen::Matrix4cd> solver(a);
  EigenWaves waves;
  for (int wave = 0; wave < 2; ++wave) {
    Complex q = std::sqrt(density / (wave == 0 ? m : g) - p * p);
    q = (s * q).real() < 0.0 ? -q : q;
    for (const int direction : {0, 2}) {
      const Complex wanted = direction == 0 ? -q : q;
      Eigen::Index nearest = 0;
      (solver.eigenvalues().array() - wanted).abs().minCoeff(&nearest);
      waves.vectors.col(direction + wave) = solver.eigenvectors().col(nearest);
      waves.exponents[direction + wave] = s * solver.eigenvalues()[nearest];
    }
  }
  return waves;
}

/// A profile under one incident wave at one frequency.
class SecondMethod {
public:
  SecondMethod(const wavefield::LayeredHalfSpace& profile, wavefield::WaveType wave, double angle_rad,
               double frequency_hz)
      : profile_(profile), s_(0.0, 2.0 * std::numbers::pi * frequency_hz) {
    const double p = wavefield::slowness_x(profile.half_space, {.wave = wave, .angle_rad = angle_rad});
    const double z = profile.half_space.density * profile.half_space.vs;
    for (std::size_t j = 0; j <= profile.layers.size(); ++j) {
      const double density =
          j < profile.layers.size() ? profile.layers[j].density : profile.half_space.density;
      waves_.push_back(eigen_waves(density, wavefield::MediumModuli(profile, j).at(s_), p, z, s_));
    }
    // Unit velocity: vx^2 + vy^2 = 1, to the right for SV and upwards for P.
    const int column = wave == wavefield::WaveType::P ? 0 : 1;
    incident_ = waves_.back().vectors.col(column);
    incident_ /= std::sqrt(incident_[0] * incident_[0] + incident_[1] * incident_[1]);
    if (incident_[wave == wavefield::WaveType::P ? 1 : 0].real() < 0.0) {
      incident_ = -incident_;
    }
  }

  /// Velocities (vx, vy) at all layer faces, the surface first, per unit velocity of the incident wave.
  std::vector<Eigen::Vector2cd> by_stiffness() const {
    const auto layers = static_cast<Eigen::Index>(profile_.layers.size());
    Eigen::MatrixXcd k = Eigen::MatrixXcd::Zero(2 * layers + 2, 2 * layers + 2);
    for (Eigen::Index j = 0; j < layers; ++j) {
      const Layer layer = faces(static_cast<std::size_t>(j));
      // Tractions on the layer's own faces, outward normals +y and -y.
      Eigen::Matrix4cd tractions = layer.stresses;
      tractions.bottomRows<2>() *= -1.0;
      k.block<4, 4>(2 * j, 2 * j) += tractions * layer.velocities.inverse();
    }
    const Eigen::Matrix<Complex, 4, 2> down = waves_.back().vectors.rightCols<2>();
    const Eigen::Matrix2cd below = down.bottomRows<2>() * down.topRows<2>().inverse();
    k.bottomRightCorner<2, 2>() += below;
    // What the half-space pulls at the layers beyond its own stiffness: the incident wave's part.
    Eigen::VectorXcd load = Eigen::VectorXcd::Zero(2 * layers + 2);
    load.tail<2>() = -(incident_.tail<2>() - below * incident_.head<2>());
    const Eigen::VectorXcd v = k.partialPivLu().solve(load);
    std::vector<Eigen::Vector2cd> at_faces;
    for (Eigen::Index j = 0; j <= layers; ++j) {
      at_faces.emplace_back(v.segment<2>(2 * j));
    }
    return at_faces;
  }

  /// Velocity of the surface by propagator matrices in double precision.
  Eigen::Vector2cd by_naive_propagators() const {
    Eigen::Matrix4cd to_bottom = Eigen::Matrix4cd::Identity();
    for (std::size_t j = 0; j < profile_.layers.size(); ++j) {
      const double h = profile_.layers[j].thickness;
      const Eigen::Vector4cd growth = (-h * waves_[j].exponents).array().exp();
      to_bottom = waves_[j].vectors * growth.asDiagonal() * waves_[j].vectors.inverse() * to_bottom;
    }
    Eigen::Matrix4cd unknowns;
    unknowns << to_bottom.leftCols<2>(), -waves_.back().vectors.rightCols<2>();
    return unknowns.partialPivLu().solve(incident_).eval().head<2>();
  }

private:
  /// Velocities and stresses of a layer's four waves at its top (rows 0, 1) and bottom (rows 2, 3); each wave
  /// is 1 where it enters.
  struct Layer {
    Eigen::Matrix4cd velocities, stresses;
  };

  Layer faces(std::size_t j) const {
    const EigenWaves& waves = waves_[j];
    Layer layer;
    for (int i = 0; i < 4; ++i) {
      const bool up = i < 2;
      const Complex other = std::exp((up ? 1.0 : -1.0) * waves.exponents[i] * profile_.layers[j].thickness);
      const Eigen::Vector4cd column = waves.vectors.col(i);
      layer.velocities.col(i) << column.head<2>() * (up ? other : 1.0), column.head<2>() * (up ? 1.0 : other);
      layer.stresses.col(i) << column.tail<2>() * (up ? other : 1.0), column.tail<2>() * (up ? 1.0 : other);
    }
    return layer;
  }

  wavefield::LayeredHalfSpace profile_;
  Complex s_;
  std::vector<EigenWaves> waves_;
  Eigen::Vector4cd incident_;
};

} // namespace tremolo::testing
