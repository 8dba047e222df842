// A generalised Maxwell body (Emmerich and Korn 1987, Geophysics 52, 1252-1264). With G the modulus at the
// reference frequency,
//
//     G*(s) = G_R + sum_j M_j s tau_j/(1 + s tau_j),    G_R + sum_j M_j = G_U.
//
// In time each mechanism bears a stress q_j of its own beside that of the law,
//
//     dq_j/dt + q_j/tau_j = w_j d sigma/dt,    w_j = M_j/G_R,    stress = sigma + sum_j q_j,
//
// sigma being the stress of the law for the strain increment (G_R/G) d eps: its stiffness is then G_R, its
// strength is its own. Driven by strain with the stiffness at small strain, mechanisms would go on where soil
// yields and bear up to twice its strength.
//
// Over a step of dt the trapezoidal rule, a = dt/tau_j, which is of second order and stable for all a:
//
//     q_j -> [(1 - a/2) q_j + w_j d sigma]/(1 + a/2).

#include "materials/relaxation/relaxation.hpp"

#include <numeric>

namespace tremolo::materials {

double Relaxation::unrelaxed() const {
  return relaxed * std::accumulate(weight.begin(), weight.end(), 1.0);
}

std::complex<double> Relaxation::factor(std::complex<double> s) const {
  std::complex<double> sum = 1.0;
  for (std::size_t j = 0; j < time.size(); ++j)
    sum += weight[j] * s * time[j] / (1.0 + s * time[j]);
  return relaxed * sum;
}

Relaxation Relaxation::on_share(double share) const {
  Relaxation result = *this;
  result.relaxed = 1.0 - share + share * relaxed;
  for (double& w : result.weight)
    w *= share * relaxed / result.relaxed;
  return result;
}

RelaxationStep relaxation_step(const Relaxation& relaxation, std::size_t j, double dt) {
  const double half = 0.5 * dt / relaxation.time[j];
  return {(1.0 - half) / (1.0 + half), relaxation.weight[j] / (1.0 + half)};
}

} // namespace tremolo::materials
