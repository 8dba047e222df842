// All fields depend on t - p x, so d/dx = -p d/dt and eps_xx = -p vx. With rho dvx/dt = d sxx/dx + d sxy/dy
// and so on and Hooke's law, M = lambda + 2 mu,
//
//     A = [ rho - p^2 (M - lambda^2/M)   p lambda/M ]     B = [ 1/mu   p   ]
//         [ p lambda/M                   1/M        ]         [ p      rho ].
//
// det A > 0 iff p < 1/c_p, det B > 0 iff p < 1/c_s. Then (a'A a + b'B b)/2 is an energy, and a'b its flux
// upwards.
//
// Half-space: plane P and SV waves of velocity d (Aki and Richards 2002, Quantitative Seismology, sec. 5.2),
// with gamma = 1 - 2 c_s^2 p^2, q = sqrt(1/c^2 - p^2), upper sign upgoing,
//
//     P   d = (c_p p, +-c_p q_p)       sxy = -+2 mu c_p p q_p       syy = -rho c_p gamma
//     SV  d = (c_s q_s, -+c_s p)       sxy = -+rho c_s gamma        syy = 2 mu c_s p q_s.
//
// As columns of matrices, a = A_u w_u + A_d w_d and b = B_u w_u + B_d w_d for amplitudes w. The incident ones
// are those of the incident velocity, w_u = D_u^-1 v; the outgoing ones are free, so that
//
//     b = Z a + (B_u - Z A_u) D_u^-1 v,   Z = B_d A_d^-1:
//
// an impedance without frequency, exact in time.

#include "freefield/oblique/oblique_medium.hpp"

#include "base/require.hpp"

#include <Eigen/LU>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tremolo::freefield {
namespace {

/// Columns P and SV of waves that go up (+1) or down (-1).
struct Waves {
  Eigen::Matrix2d velocity, a, b;
};

Waves waves(const materials::Elasticity& soil, double p, double direction) {
  const double cp = soil.p_wave_speed();
  const double cs = soil.s_wave_speed();
  const double qp = vertical_slowness(cp, p);
  const double qs = vertical_slowness(cs, p);
  const double mu = soil.shear_modulus();
  const double gamma = 1.0 - 2.0 * cs * cs * p * p;
  Waves w;
  w.velocity << cp * p, cs * qs, direction * cp * qp, -direction * cs * p;
  w.a << cp * p, cs * qs, -soil.density * cp * gamma, 2.0 * mu * cs * p * qs;
  w.b << -direction * 2.0 * mu * cp * p * qp, -direction * soil.density * cs * gamma, direction * cp * qp,
      -direction * cs * p;
  return w;
}

std::string degrees(double sine) {
  return sine >= 1.0 ? "90" : shortest(std::asin(sine) * 180.0 / std::numbers::pi);
}

} // namespace

double vertical_slowness(double speed, double slowness_x) {
  return std::sqrt(1.0 / (speed * speed) - slowness_x * slowness_x);
}

ObliqueMedium oblique_medium(const materials::Elasticity& soil, double p) {
  const double m = soil.p_modulus();
  const double lambda = soil.lame();
  ObliqueMedium medium;
  medium.a << soil.density - p * p * (m - lambda * lambda / m), p * lambda / m, p * lambda / m, 1.0 / m;
  medium.b << 1.0 / soil.shear_modulus(), p, p, soil.density;
  return medium;
}

ObliqueBase oblique_base(const materials::Elasticity& half_space, double p) {
  const Waves up = waves(half_space, p, 1.0);
  const Waves down = waves(half_space, p, -1.0);
  const Eigen::Matrix2d impedance = down.b * down.a.inverse();
  return {impedance, (up.b - impedance * up.a) * up.velocity.inverse()};
}

void validate_slowness(const Profile& profile, double slowness_x) {
  double fastest = profile.half_space.p_wave_speed();
  std::string where = "the half-space";
  for (std::size_t i = 0; i < profile.layers.size(); ++i) {
    const double speed = profile.layers[i].soil.p_wave_speed();
    if (speed > fastest) {
      fastest = speed;
      where = "layer " + std::to_string(i + 1) + " from the top";
    }
  }
  require(slowness_x >= 0.0 && slowness_x * fastest < 1.0, "horizontal slowness", slowness_x,
          "at least 0 and below 1/c_p = " + shortest(1.0 / fastest) + " s/m of " + where +
              ": incident SV waves below " + degrees(profile.half_space.s_wave_speed() / fastest) +
              " degrees, P waves below " + degrees(profile.half_space.p_wave_speed() / fastest) +
              " degrees. Beyond, a column in time is an ill-posed problem; the model `wave` takes any angle");
}

} // namespace tremolo::freefield
