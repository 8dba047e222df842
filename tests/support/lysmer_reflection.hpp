#pragma once

// What Lysmer dashpots (rho c_p across, rho c_s along the boundary) reflect of a plane wave, in closed form:
// the reflected P and SV wave whose tractions, added to those of the incident one, are the dashpots' own,
//
//     sum_m A_m (t_m + C w_m) = 0,      w = i omega d,      C = diag(rho c_s, rho c_p),
//
// at every point of the boundary. Slownesses beyond 1/c_p make the P wave evanescent.

#include "materials/elastic/elasticity.hpp"

#include <cmath>
#include <complex>

namespace tremolo::test_support {

/// Reflected over incident energy flux through the boundary.
/// @param angle from the normal, rad
inline double lysmer_reflected_energy(const materials::Elasticity& ground, bool sv, double angle) {
  using Complex = std::complex<double>;
  const double a = ground.p_wave_speed(), b = ground.s_wave_speed(), rho = ground.density;
  const double mu = rho * b * b, lame = rho * (a * a - 2.0 * b * b);
  const double p = std::sin(angle) / (sv ? b : a);
  struct Ray {
    Complex x, z; ///< traction plus dashpot
    double flux;  ///< per squared amplitude
  };
  // A wave exp(i omega (t - p x - q z)) of unit velocity towards +z, where the boundary lies: q > 0 for the
  // incident.
  const auto ray = [&](bool shear, double sign) {
    const double c = shear ? b : a;
    Complex q = std::sqrt(Complex(1.0 / (c * c) - p * p));
    if (q.imag() > 0.0)
      q = -q; // dies away from the boundary
    const Complex s = sign * q;
    const Complex wx = shear ? c * s : Complex(c * p);
    const Complex wz = shear ? Complex(-c * p) : c * s;
    const Complex txz = -mu * (s * wx + p * wz);
    const Complex tzz = -(lame * (p * wx + s * wz) + 2.0 * mu * s * wz);
    return Ray{txz + rho * b * wx, tzz + rho * a * wz, rho * c * c * q.real()};
  };
  const Ray in = ray(sv, 1.0), up_p = ray(false, -1.0), up_s = ray(true, -1.0);
  const Complex det = up_p.x * up_s.z - up_s.x * up_p.z;
  const Complex amplitude_p = (-in.x * up_s.z + up_s.x * in.z) / det;
  const Complex amplitude_s = (-up_p.x * in.z + in.x * up_p.z) / det;
  return (std::norm(amplitude_p) * up_p.flux + std::norm(amplitude_s) * up_s.flux) / in.flux;
}

} // namespace tremolo::test_support
