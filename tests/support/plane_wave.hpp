#pragma once

// A plane SV wave below the critical angle in a homogeneous half-space with free surface y = 0, in closed
// form: three delayed Ricker pulses (incident S, reflected P, reflected S) with real coefficients (Aki and
// Richards 2002, sec. 5.2),
//
//     v = sum_m A_m d_m f(t - p x - q_m (y - y_m)),    sigma = -sum_m A_m S_m f(...).
//
// Written out here once more, independently of tremolo::wavefield, which works in the frequency domain.

#include "coupler/eq6/boundary_traction.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace tremolo::test_support {

struct PlaneWave {
  double density = 1700.0, vs = 95.87062360592131, vp = 173.4364837735801;
  double angle = 0.0; ///< rad
  double frequency = 3.0, arrival = 1.0, amplitude = 0.1;
  double repeat = 1e9;        ///< s from one pulse to the next
  double y_reference = -40.0; ///< the incident wave passes (0, y_reference) at `arrival`

  double ricker(double t) const {
    const double a = std::pow(std::numbers::pi * frequency * std::remainder(t - arrival, repeat), 2);
    return amplitude * (1.0 - 2.0 * a) * std::exp(-a);
  }

  struct Ray {
    double amplitude, qy; ///< qy: signed vertical slowness
    double ux, uy;        ///< polarisation
    double sxx, syy, sxy; ///< stress per unit velocity, with the sign of -S
  };

  double p() const { return std::sin(angle) / vs; }

  std::array<Ray, 3> rays() const {
    const double b = vs, a = vp, rho = density;
    const double qa = std::sqrt(1.0 / (a * a) - p() * p());
    const double qb = std::sqrt(1.0 / (b * b) - p() * p());
    const double c2 = 1.0 - 2.0 * b * b * p() * p();
    const double k = 4.0 * b * b * b * b * p() * p() * qa * qb;
    const double det = c2 * c2 + k;
    const double rs = (c2 * c2 - k) / det;
    const double rp = 4.0 * b * b * b / a * p() * qb * c2 / det;
    const auto ray = [&](double amp, double q, double ux, double uy) {
      // Hooke with d/dx = -p d/dt, d/dy = -q d/dt.
      const double mu = rho * b * b, lambda = rho * (a * a - 2.0 * b * b);
      const double exx = -p() * ux, eyy = -q * uy, gxy = -(q * ux + p() * uy);
      return Ray{
          amp,     q, ux, uy, (lambda + 2 * mu) * exx + lambda * eyy, (lambda + 2 * mu) * eyy + lambda * exx,
          mu * gxy};
    };
    return {ray(1.0, qb, b * qb, -b * p()), ray(rp, -qa, a * p(), -a * qa), ray(rs, -qb, b * qb, b * p())};
  }

  /// @param rays_used 3 for the total field, 1 for the incident wave alone
  eq6::FreeField at(double x, double y, double t, int rays_used = 3) const {
    eq6::FreeField field;
    const auto all = rays();
    const double lead = all[0].qy * y_reference; // every ray passes (0, 0) as the incident one does
    for (int m = 0; m < rays_used; ++m) {
      const Ray& r = all[static_cast<std::size_t>(m)];
      const double f = r.amplitude * ricker(t - p() * x - r.qy * y + lead);
      field.velocity.x += r.ux * f;
      field.velocity.y += r.uy * f;
      field.stress.xx += r.sxx * f;
      field.stress.yy += r.syy * f;
      field.stress.xy += r.sxy * f;
    }
    return field;
  }
};

} // namespace tremolo::test_support
