// Semi-discrete form, per m2 of plan area: nodes i from the base up, elements e with strain eps = (u_{i+1} -
// u_i)/h,
//
//     m_i a_i + c_i v_i = tau_above - tau_below,   tau_e = E (eps + beta deps/dt),   m_i, alpha part of c_i
//     lumped
//
// and at the base node the traction of the half-space (Joyner and Chen 1975, BSSA 65(5), 1315-1336)
//
//     t = -rho c (v_0 - 2 v_incident).
//
// Newmark (1/4, 1/2):   u' = u + dt v + dt^2/4 (a + a'),   v' = v + dt/2 (a + a')
//     (m + dt/2 c + (dt^2/4 + beta dt/2) K) a' = t_inc - c v* - K u* - beta K v*,   * = without a'.
//
// Central differences in velocity form:   u' = u + dt v + dt^2/2 a,   v' = v + dt/2 (a + a')
//     (m + dt/2 c) a' = t_inc - c v* - K u' - beta K (v + dt a).
// The damping stress of the elements takes the velocity extrapolated to the step's end, v + dt a, which keeps
// second order; the customary velocity of half a step ago would make it first order. With D = beta w^2 dt a
// mode of angular frequency w has the characteristic polynomial
//     z^3 + (w^2 dt^2 + 3D/2 - 2) z^2 + (1 - 2D) z + D/2,
// whose roots stay in the unit circle (Jury) iff dt (dt + 4 beta) w^2 < 4. Summed over elements, each with
// its own beta, this holds for the whole column if it holds for each element alone, w_e = 2 c / h:
//     dt < sqrt(4 beta^2 + (h/c)^2) - 2 beta.
//
// Stress between nodes: tau is second-order accurate at the element's centre, and d tau/dy = rho (a + alpha
// v) carries it to the rest of the element with the motion of the nearer node. This is the node's own
// equation of motion, so tau is continuous across nodes and layer interfaces, 0 at the surface and the
// dashpot's at the base.

#include "freefield/scalar_column.hpp"

#include "freefield/require.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tremolo::freefield {

double central_difference_limit(const std::vector<ScalarElement>& elements) {
  double limit = std::numeric_limits<double>::infinity();
  for (const ScalarElement& e : elements) {
    const double crossing = e.length * std::sqrt(e.density / e.modulus); // h/c, s
    limit = std::min(limit, std::hypot(2.0 * e.beta, crossing) - 2.0 * e.beta);
  }
  return limit;
}

ScalarColumn::ScalarColumn(std::vector<ScalarElement> elements, double base_impedance, double time_step,
                           Integrator integrator)
    : elements_(std::move(elements)), impedance_(base_impedance), dt_(time_step), integrator_(integrator),
      mass_(elements_.size() + 1), dashpots_(mass_.size()), u_(mass_.size()), v_(mass_.size()),
      a_(mass_.size()), jerk_(mass_.size()), stress_velocity_(mass_.size()) {
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const double half_mass = 0.5 * elements_[e].density * elements_[e].length;
    for (const std::size_t node : {e, e + 1}) {
      mass_[node] += half_mass;
      dashpots_[node] += elements_[e].alpha * half_mass;
    }
  }
  dashpots_[0] += impedance_;
  if (integrator_ == Integrator::newmark) {
    factor_newmark();
    return;
  }
  const double limit = central_difference_limit(elements_);
  require(dt_ < limit, "time step of the column", dt_,
          "below " + shortest(limit) +
              " s, the stability limit of central differences for its elements, wave "
              "speeds and damping (larger elements or Newmark allow more)");
}

void ScalarColumn::step(double incident_velocity) {
  if (integrator_ == Integrator::newmark) {
    step_newmark(incident_velocity);
  } else {
    step_central_difference(incident_velocity);
  }
  if (!std::all_of(a_.begin(), a_.end(), [](double a) { return std::isfinite(a); })) {
    throw std::runtime_error("the motion of the free-field column is no longer finite; incident velocity " +
                             shortest(incident_velocity) + " m/s");
  }
}

ScalarColumn::Vector ScalarColumn::internal_forces(const Vector& u, const Vector& v) const {
  Vector force(u.size());
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const ScalarElement& element = elements_[e];
    const double stress =
        element.modulus / element.length * ((u[e + 1] - u[e]) + element.beta * (v[e + 1] - v[e]));
    force[e] -= stress;
    force[e + 1] += stress;
  }
  return force;
}

void ScalarColumn::step_central_difference(double incident_velocity) {
  const Vector v_before = v_;
  const double traction_before = base_traction();
  for (std::size_t i = 0; i < u_.size(); ++i) {
    u_[i] += dt_ * v_[i] + 0.5 * dt_ * dt_ * a_[i];
    stress_velocity_[i] = v_[i] + dt_ * a_[i];
    v_[i] += 0.5 * dt_ * a_[i];
  }
  const Vector forces = internal_forces(u_, stress_velocity_);
  incident_ = incident_velocity;
  for (std::size_t i = 0; i < u_.size(); ++i) {
    const double driving = i == 0 ? 2.0 * impedance_ * incident_ : 0.0;
    const double a = (driving - forces[i] - dashpots_[i] * v_[i]) / (mass_[i] + 0.5 * dt_ * dashpots_[i]);
    jerk_[i] = (a - a_[i]) / dt_;
    a_[i] = a;
    v_[i] += 0.5 * dt_ * a;
  }
  account(v_before, traction_before);
}

void ScalarColumn::step_newmark(double incident_velocity) {
  const Vector v_before = v_;
  const double traction_before = base_traction();
  for (std::size_t i = 0; i < u_.size(); ++i) {
    u_[i] += dt_ * v_[i] + 0.25 * dt_ * dt_ * a_[i];
    v_[i] += 0.5 * dt_ * a_[i];
  }
  Vector a = internal_forces(u_, v_);
  incident_ = incident_velocity;
  for (std::size_t i = 0; i < u_.size(); ++i) {
    const double driving = i == 0 ? 2.0 * impedance_ * incident_ : 0.0;
    a[i] = driving - a[i] - dashpots_[i] * v_[i];
  }
  solve_newmark(a);
  for (std::size_t i = 0; i < u_.size(); ++i) {
    u_[i] += 0.25 * dt_ * dt_ * a[i];
    v_[i] += 0.5 * dt_ * a[i];
    jerk_[i] = (a[i] - a_[i]) / dt_;
  }
  a_ = std::move(a);
  stress_velocity_ = v_;
  account(v_before, traction_before);
}

/// L D L^T of the tridiagonal Newmark matrix, once.
void ScalarColumn::factor_newmark() {
  Vector off_diagonal(elements_.size());
  factor_diagonal_ = mass_;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    factor_diagonal_[i] += 0.5 * dt_ * dashpots_[i];
  }
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const ScalarElement& element = elements_[e];
    const double stiffness = element.modulus / element.length * (0.25 * dt_ * dt_ + 0.5 * dt_ * element.beta);
    factor_diagonal_[e] += stiffness;
    factor_diagonal_[e + 1] += stiffness;
    off_diagonal[e] = -stiffness;
  }
  factor_below_.resize(elements_.size());
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    factor_below_[e] = off_diagonal[e] / factor_diagonal_[e];
    factor_diagonal_[e + 1] -= factor_below_[e] * off_diagonal[e];
  }
}

void ScalarColumn::solve_newmark(Vector& x) const {
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    x[e + 1] -= factor_below_[e] * x[e];
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] /= factor_diagonal_[i];
  }
  for (std::size_t e = elements_.size(); e-- > 0;) {
    x[e] -= factor_below_[e] * x[e + 1];
  }
}

/// Work and dissipation of a step by the trapezoidal rule: exact for Newmark, second order for central
/// differences.
void ScalarColumn::account(const Vector& v_before, double base_traction_before) {
  const auto mean_velocity = [&](std::size_t i) { return 0.5 * (v_before[i] + v_[i]); };
  spent_.base_work += dt_ * 0.5 * (base_traction_before + base_traction()) * mean_velocity(0);
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const ScalarElement& element = elements_[e];
    const double below = mean_velocity(e);
    const double above = mean_velocity(e + 1);
    const double difference = above - below;
    const double half_mass = 0.5 * element.density * element.length;
    spent_.damping += dt_ * (element.beta * element.modulus / element.length * difference * difference +
                             element.alpha * half_mass * (below * below + above * above));
  }
}

ColumnEnergy ScalarColumn::energy() const {
  ColumnEnergy energy = spent_;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    energy.kinetic += 0.5 * mass_[i] * v_[i] * v_[i];
  }
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const double difference = u_[e + 1] - u_[e];
    energy.strain += 0.5 * elements_[e].modulus / elements_[e].length * difference * difference;
  }
  return energy;
}

ScalarSample ScalarColumn::sample(std::size_t e, double fraction) const {
  const ScalarElement& element = elements_[e];
  const auto interpolate = [&](const Vector& nodal) { return std::lerp(nodal[e], nodal[e + 1], fraction); };
  const auto gradient = [&](const Vector& nodal) { return (nodal[e + 1] - nodal[e]) / element.length; };
  const std::size_t nearer = fraction < 0.5 ? e : e + 1;
  const double mass_from_centre = element.density * element.length * (fraction - 0.5);
  return {.velocity = interpolate(v_),
          .acceleration = interpolate(a_),
          .traction = element.modulus * (gradient(u_) + element.beta * gradient(stress_velocity_)) +
                      mass_from_centre * (a_[nearer] + element.alpha * v_[nearer]),
          .traction_rate = element.modulus * (gradient(v_) + element.beta * gradient(a_)) +
                           mass_from_centre * (jerk_[nearer] + element.alpha * a_[nearer])};
}

} // namespace tremolo::freefield
