#pragma once

#include "tests/support/biot_waves.hpp"

#include <complex>

namespace tremolo::freefield::testing {

/// The column of height H under e^{i w t} of effective stress at its drained surface, on a rigid impervious
/// base: both waves (biot_waves.hpp), up and down.
class HarmonicColumn {
public:
  HarmonicColumn(double height, double modulus, double permeability, double frequency) {
    const auto pores = *wet_layer(1.0, modulus, permeability).pores;
    const double q = materials::pore_stiffness(pores, water);
    const auto waves = biot_waves(modulus, permeability, frequency);
    Eigen::Matrix2cd surface;
    for (int m = 0; m < 2; ++m) {
      number_[m] = waves[m].number;
      solid_[m] = waves[m].mode(0);
      // u = U sin(k y): effective stress M u_s'.
      const auto slope = number_[m] * std::cos(number_[m] * height);
      surface(0, m) = modulus * solid_[m] * slope;
      pressure_[m] = waves[m].pressure(pores.porosity, q) * number_[m];
      surface(1, m) = pressure_[m] * std::cos(number_[m] * height);
    }
    const Eigen::Vector2cd loads = surface.fullPivLu().solve(Eigen::Vector2cd(1.0, 0.0));
    amplitude_[0] = loads(0);
    amplitude_[1] = loads(1);
  }

  /// The pressure p at height y over the base, for a unit load.
  std::complex<double> pressure(double y) const {
    return amplitude_[0] * pressure_[0] * std::cos(number_[0] * y) +
           amplitude_[1] * pressure_[1] * std::cos(number_[1] * y);
  }
  /// The displacement of the grains at height y, for a unit load.
  std::complex<double> displacement(double y) const {
    return amplitude_[0] * solid_[0] * std::sin(number_[0] * y) +
           amplitude_[1] * solid_[1] * std::sin(number_[1] * y);
  }

private:
  std::complex<double> number_[2], solid_[2], pressure_[2], amplitude_[2];
};

} // namespace tremolo::freefield::testing
