// With p = sin(angle)/c, q_c = sqrt(1/c^2 - p^2) and c_2 = 1 - 2 b^2 p^2 (a = vp, b = vs, mu = rho b^2), a
// plane wave exp(i w (t - p x - q y)) of unit particle velocity has
//
//           v_x    v_y      s_xy           s_yy           s_xx
//     P     a p    a q     -2 mu a p q    -rho a c_2     -a (rho - 2 mu q^2)         q = +q_a up, -q_a down
//     SV    b q_b  -+b p   -+rho b c_2    +2 mu b p q_b  -2 mu b p q_b               upper sign up, lower
//     sign down
//
// and vanishing traction at y = 0 gives, with X = 4 b^4 p^2 q_a q_b and D = c_2^2 + X (Aki and Richards 2002,
// Quantitative Seismology, sec. 5.2),
//
//     incident SV:  R_S = (c_2^2 - X) / D     R_P = 4 (b^3/a) p q_b c_2 / D
//     incident P:   R_P = (X - c_2^2) / D     R_S = 4 a b p q_a c_2 / D
//
// Beyond the critical angle q_a = -i sqrt(p^2 - 1/a^2) for w > 0: the reflected P wave decays with depth.
// Nothing is singular at vertical incidence, p = 0.

#include "wavefield/plane_waves.hpp"

#include <cmath>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;

/// sqrt(1/c^2 - p^2) on the branch of waves that decay away from their source, for w > 0.
Complex vertical_slowness(double speed, double p) {
  const double squared = (1.0 / speed - p) * (1.0 / speed + p);
  return squared >= 0.0 ? Complex(std::sqrt(squared), 0.0) : Complex(0.0, -std::sqrt(-squared));
}

PlaneWave p_wave(const HalfSpace& soil, double p, Complex q) {
  const double a = soil.vp;
  const double mu = soil.density * soil.vs * soil.vs;
  const double c2 = 1.0 - 2.0 * soil.vs * soil.vs * p * p;
  return {.q = q,
          .vx = a * p,
          .vy = a * q,
          .sxx = -a * (soil.density - 2.0 * mu * q * q),
          .syy = -soil.density * a * c2,
          .sxy = -2.0 * mu * a * p * q};
}

PlaneWave sv_wave(const HalfSpace& soil, double p, Complex q_b, double direction) {
  const double b = soil.vs;
  const double mu = soil.density * b * b;
  const double c2 = 1.0 - 2.0 * b * b * p * p;
  return {.q = direction * q_b,
          .vx = b * q_b,
          .vy = -direction * b * p,
          .sxx = -2.0 * mu * b * p * q_b,
          .syy = 2.0 * mu * b * p * q_b,
          .sxy = -direction * soil.density * b * c2};
}

PlaneWave scaled(PlaneWave wave, Complex amplitude) {
  for (Complex* quantity : {&wave.vx, &wave.vy, &wave.sxx, &wave.syy, &wave.sxy}) {
    *quantity *= amplitude;
  }
  return wave;
}

} // namespace

PlaneWaves plane_waves(const HalfSpace& soil, const Incidence& incidence) {
  const double a = soil.vp;
  const double b = soil.vs;
  const double p = slowness_x(soil, incidence);
  const Complex q_a = vertical_slowness(a, p);
  const Complex q_b = vertical_slowness(b, p);
  const double c2 = 1.0 - 2.0 * b * b * p * p;
  const Complex coupling = 4.0 * std::pow(b, 4) * p * p * q_a * q_b;
  const Complex denominator = c2 * c2 + coupling;

  const PlaneWave down_p = p_wave(soil, p, -q_a);
  const PlaneWave down_s = sv_wave(soil, p, q_b, -1.0);
  if (incidence.wave == WaveType::SV) {
    const Complex r_p = 4.0 * (b * b * b / a) * p * q_b * c2 / denominator;
    const Complex r_s = (c2 * c2 - coupling) / denominator;
    return {sv_wave(soil, p, q_b, 1.0), scaled(down_p, r_p), scaled(down_s, r_s)};
  }
  const Complex r_p = (coupling - c2 * c2) / denominator;
  const Complex r_s = 4.0 * a * b * p * q_a * c2 / denominator;
  return {p_wave(soil, p, q_a), scaled(down_p, r_p), scaled(down_s, r_s)};
}

} // namespace tremolo::wavefield
