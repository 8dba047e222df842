// An element's share of the strain energy is (1/2h) [M dv_s^2 + Q (dv_s + d(n_I w))^2], d the difference of
// its nodes; with (a - b)^2 <= 2 (a^2 + b^2) no eigenvalue of the column exceeds the largest of
//
//     4/h^2 times that of  [ M + Q (1-n_I)^2   Q n_I (1-n_I) ]  relative to  diag((1-n) rho_s, n rho_f)
//                          [ Q n_I (1-n_I)     Q n_I^2       ]
//
// over elements and their nodes: without jumps of porosity 4 c_1^2/h^2. Where fields depend on t - s x, waves
// travel along y with 1/sqrt(1/c_1^2 - s^2) in place of c_1 (marched/marched_trial.cpp). Damping that lags
// half a step behind takes the step from 2/omega to (2/omega)(sqrt(1 + xi^2) - xi), xi the ratio of damping
// at omega.

#include "freefield/twophase/step_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::freefield {
namespace {

/// The largest eigenvalue, m2/s2: the square of a speed.
double fastest(const WetElement& element, double modulus, double n) {
  const double s = (modulus + element.stiffness * (1.0 - n) * (1.0 - n)) / element.solid_share;
  if (!element.flows())
    return s;
  const double f = element.stiffness * n * n / element.fluid_share;
  const double sf = element.stiffness * n * (1.0 - n) / std::sqrt(element.solid_share * element.fluid_share);
  return 0.5 * (s + f) + std::hypot(0.5 * (s - f), sf);
}

double damped(double omega, double viscous_rate) {
  const double ratio = viscous_rate / (2.0 * omega);
  return 2.0 / omega * (std::hypot(1.0, ratio) - ratio);
}

} // namespace

double fast_wave_speed(const WetGrid& grid, std::size_t e, double p_modulus) {
  double speed2 = 0.0;
  for (const std::size_t i : {e, e + 1}) {
    const double n = grid.elements[e].flows() ? grid.nodes[i].porosity() : 0.0;
    speed2 = std::max(speed2, fastest(grid.elements[e], p_modulus, n));
  }
  return std::sqrt(speed2);
}

double step_limit(const WetGrid& grid, const std::vector<double>& p_moduli, double slowness_x) {
  double limit = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < grid.elements.size(); ++e) {
    const WetElement& element = grid.elements[e];
    const double scale = 2.0 / element.length;
    const auto limit_of = [&](double speed2, double modulus) {
      const double left = 1.0 - slowness_x * slowness_x * speed2;
      if (left <= 0.0)
        return 0.0;
      return damped(scale * std::sqrt(speed2 / left),
                    element.beta * scale * scale * modulus / (left * element.solid_share));
    };
    for (const std::size_t i : {e, e + 1}) {
      const double n = element.flows() ? grid.nodes[i].porosity() : 0.0;
      limit = std::min(limit, limit_of(fastest(element, p_moduli[e], n), p_moduli[e]));
    }
    const double shear = element.shear_ratio * p_moduli[e];
    limit = std::min(limit, limit_of(shear / element.solid_share, shear));
  }
  return limit;
}

} // namespace tremolo::freefield
