// Semi-discrete form, per m2 of plan area: nodes i from the base up, elements e with strain
// eps = (u_{i+1} - u_i)/h; m_i and the alpha part of c_i are lumped,
//
//     m_i a_i + c_i (v_i - v_ref) = tau_above - tau_below,   tau_e = E (eps + beta deps/dt),
//
// v_ref of base_motion.hpp, and at the base node the traction of the half-space (Joyner and Chen 1975, BSSA
// 65(5), 1315-1336)
//
//     t = -rho c (v_0 - 2 v_incident).
//
// or a prescribed motion, u_0(t). With r = K u + beta K v + c (v - v_ref) - f, which is all but inertia:
//
// Hilber, Hughes and Taylor, beta_N = (1 - alpha)^2/4, gamma = 1/2 - alpha (alpha = 0: average acceleration):
//     u' = u + dt v + dt^2 ((1/2 - beta_N) a + beta_N a'),   v' = v + dt ((1 - gamma) a + gamma a')
//     m a' + (1 + alpha) r' - alpha r = 0,
// one constant tridiagonal matrix for a'. With alpha < 0, a' is not the acceleration at the step's end to
// second order; -r'/m is, and that is what is sampled.
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
// (v - v_ref)) carries it to the rest of the element with the motion of the nearer node. This is the node's
// own equation of motion, so tau is continuous across nodes and layer interfaces, 0 at the surface and the
// dashpot's at the base.

#include "freefield/fe/scalar_column.hpp"

#include "base/require.hpp"

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

void require_stable(double time_step, double limit) {
  require(time_step < limit, "time step of the column", time_step,
          "below " + shortest(limit) +
              " s, the stability limit of central differences for its elements, wave "
              "speeds and damping (larger elements or Newmark allow more)");
}

ScalarColumn::ScalarColumn(std::vector<ScalarElement> elements, const ScalarSettings& settings)
    : elements_(std::move(elements)), settings_(settings),
      hht_(HhtParameters::from_alpha(settings.hht_alpha)), mass_(elements_.size() + 1),
      mass_damping_(mass_.size()), u_(mass_.size()), v_(mass_.size()), a_(mass_.size()),
      motion_acceleration_(mass_.size()), jerk_(mass_.size()), resistance_(mass_.size()),
      stress_velocity_(mass_.size()) {
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const double half_mass = 0.5 * elements_[e].density * elements_[e].length;
    for (const std::size_t node : {e, e + 1}) {
      mass_[node] += half_mass;
      mass_damping_[node] += elements_[e].alpha * half_mass;
    }
  }
  dashpots_ = mass_damping_;
  if (!rigid())
    dashpots_[0] += settings_.base_impedance;
  if (settings_.integrator == Integrator::newmark) {
    factor_newmark();
    return;
  }
  require_stable(settings_.time_step, central_difference_limit(elements_));
}

void ScalarColumn::step(const BaseComponent& base) {
  const Vector u_before = u_;
  const Vector v_before = v_;
  const Vector acceleration_before = motion_acceleration_;
  const double reference_before = base_.reference;
  const double resistance_before = resistance_[0];
  base_ = base;
  if (settings_.integrator == Integrator::newmark)
    step_newmark();
  else
    step_central_difference();
  for (std::size_t i = 0; i < u_.size(); ++i) {
    motion_acceleration_[i] = i == 0 && rigid() ? base_.acceleration : -resistance_[i] / mass_[i];
    jerk_[i] = (motion_acceleration_[i] - acceleration_before[i]) / settings_.time_step;
  }
  reference_rate_ = (base_.reference - reference_before) / settings_.time_step;
  account(u_before, v_before, resistance_before, reference_before);
  if (!std::all_of(a_.begin(), a_.end(), [](double a) { return std::isfinite(a); })) {
    throw std::runtime_error("the motion of the free-field column is no longer finite; input velocity " +
                             shortest(base.velocity) + " m/s");
  }
}

double ScalarColumn::element_stress(std::size_t e, const Vector& u, const Vector& v) const {
  const ScalarElement& element = elements_[e];
  return element.modulus / element.length * ((u[e + 1] - u[e]) + element.beta * (v[e + 1] - v[e]));
}

ScalarColumn::Vector ScalarColumn::resistance(const Vector& u, const Vector& v,
                                              const Vector& dashpot_velocity) const {
  Vector force(u.size());
  for (std::size_t i = 0; i < u.size(); ++i)
    force[i] = dashpots_[i] * dashpot_velocity[i] - mass_damping_[i] * base_.reference;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const double stress = element_stress(e, u, v);
    force[e] -= stress;
    force[e + 1] += stress;
  }
  if (!rigid())
    force[0] -= 2.0 * settings_.base_impedance * base_.velocity;
  return force;
}

/// A rigid base moves as prescribed.
void ScalarColumn::hold_base() {
  if (rigid()) {
    u_[0] = base_.displacement;
    v_[0] = base_.velocity;
    a_[0] = base_.acceleration;
  }
}

void ScalarColumn::step_central_difference() {
  const double dt = settings_.time_step;
  for (std::size_t i = 0; i < u_.size(); ++i) {
    u_[i] += dt * v_[i] + 0.5 * dt * dt * a_[i];
    stress_velocity_[i] = v_[i] + dt * a_[i];
    v_[i] += 0.5 * dt * a_[i];
  }
  hold_base();
  resistance_ = resistance(u_, stress_velocity_, v_);
  for (std::size_t i = rigid() ? 1 : 0; i < u_.size(); ++i) {
    a_[i] = -resistance_[i] / (mass_[i] + 0.5 * dt * dashpots_[i]);
    v_[i] += 0.5 * dt * a_[i];
    resistance_[i] += 0.5 * dt * dashpots_[i] * a_[i];
  }
}

void ScalarColumn::step_newmark() {
  const double dt = settings_.time_step;
  const auto [alpha, beta, gamma] = hht_;
  for (std::size_t i = 0; i < u_.size(); ++i) {
    u_[i] += dt * v_[i] + dt * dt * (0.5 - beta) * a_[i];
    v_[i] += dt * (1.0 - gamma) * a_[i];
  }
  hold_base();
  Vector a = resistance(u_, v_, v_);
  for (std::size_t i = 0; i < u_.size(); ++i)
    a[i] = alpha * resistance_[i] - (1.0 + alpha) * a[i];
  solve_newmark(a);
  for (std::size_t i = 0; i < u_.size(); ++i) {
    u_[i] += beta * dt * dt * a[i];
    v_[i] += gamma * dt * a[i];
    resistance_[i] = (alpha * resistance_[i] - mass_[i] * a[i]) / (1.0 + alpha);
  }
  a_ = std::move(a);
  hold_base();
  stress_velocity_ = v_;
  if (rigid())
    resistance_[0] = mass_damping_[0] * (v_[0] - base_.reference) - element_stress(0, u_, v_);
}

/// L D L^T of the tridiagonal Newmark matrix, once. The row of a prescribed base is that of the identity.
void ScalarColumn::factor_newmark() {
  const double dt = settings_.time_step;
  const double weight = 1.0 + hht_.alpha;
  Vector off_diagonal(elements_.size());
  factor_diagonal_ = mass_;
  for (std::size_t i = 0; i < mass_.size(); ++i)
    factor_diagonal_[i] += weight * hht_.gamma * dt * dashpots_[i];
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const ScalarElement& element = elements_[e];
    const double stiffness =
        weight * element.modulus / element.length * (hht_.beta * dt * dt + hht_.gamma * dt * element.beta);
    factor_diagonal_[e] += stiffness;
    factor_diagonal_[e + 1] += stiffness;
    off_diagonal[e] = -stiffness;
  }
  if (rigid()) {
    factor_diagonal_[0] = 1.0;
    off_diagonal[0] = 0.0;
  }
  factor_below_.resize(elements_.size());
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    factor_below_[e] = off_diagonal[e] / factor_diagonal_[e];
    factor_diagonal_[e + 1] -= factor_below_[e] * off_diagonal[e];
  }
}

/// The increment of a prescribed base is 0: its motion is in the right-hand side already.
void ScalarColumn::solve_newmark(Vector& x) const {
  if (rigid())
    x[0] = 0.0;
  for (std::size_t e = 0; e < elements_.size(); ++e)
    x[e + 1] -= factor_below_[e] * x[e];
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] /= factor_diagonal_[i];
  for (std::size_t e = elements_.size(); e-- > 0;)
    x[e] -= factor_below_[e] * x[e + 1];
}

/// Work and dissipation of a step by the trapezoidal rule: exact for average acceleration, second order
/// otherwise. A dashpot's traction is -c v + f; the resistance of a prescribed base is its traction less its
/// inertia. Mass-proportional damping takes c (v - v_ref)^2, and what moves its dashpots with v_ref gives -c
/// (v - v_ref) v_ref.
void ScalarColumn::account(const Vector& u_before, const Vector& v_before, double resistance_before,
                           double reference_before) {
  const double dt = settings_.time_step;
  const auto mean_velocity = [&](std::size_t i) { return 0.5 * (v_before[i] + v_[i]); };
  const double half_base_mass = 0.5 * mass_[0];
  if (rigid()) {
    spent_.base_work += 0.5 * (resistance_before + resistance_[0]) * (u_[0] - u_before[0]) +
                        half_base_mass * (v_[0] * v_[0] - v_before[0] * v_before[0]);
  } else {
    const double traction = base_traction();
    spent_.base_work += dt * 0.5 * (base_traction_ + traction) * mean_velocity(0);
    base_traction_ = traction;
  }
  const double reference = 0.5 * (reference_before + base_.reference);
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const double relative = mean_velocity(i) - reference;
    spent_.damping += dt * mass_damping_[i] * relative * relative;
    spent_.base_work -= dt * mass_damping_[i] * relative * reference;
  }
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const ScalarElement& element = elements_[e];
    const double difference = mean_velocity(e + 1) - mean_velocity(e);
    spent_.damping += dt * element.beta * element.modulus / element.length * difference * difference;
  }
}

ColumnEnergy ScalarColumn::energy() const {
  ColumnEnergy energy = spent_;
  for (std::size_t i = 0; i < mass_.size(); ++i)
    energy.kinetic += 0.5 * mass_[i] * v_[i] * v_[i];
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const double difference = u_[e + 1] - u_[e];
    energy.strain += 0.5 * elements_[e].modulus / elements_[e].length * difference * difference;
  }
  return energy;
}

double ScalarColumn::strain(std::size_t e) const {
  return (u_[e + 1] - u_[e]) / elements_[e].length;
}

ScalarSample ScalarColumn::sample(std::size_t e, double fraction) const {
  const ScalarElement& element = elements_[e];
  const auto interpolate = [&](const Vector& nodal) { return std::lerp(nodal[e], nodal[e + 1], fraction); };
  const auto gradient = [&](const Vector& nodal) { return (nodal[e + 1] - nodal[e]) / element.length; };
  const std::size_t nearer = fraction < 0.5 ? e : e + 1;
  const double mass_from_centre = element.density * element.length * (fraction - 0.5);
  return {.velocity = interpolate(v_),
          .acceleration = interpolate(motion_acceleration_),
          .traction = element.modulus * (gradient(u_) + element.beta * gradient(stress_velocity_)) +
                      mass_from_centre *
                          (motion_acceleration_[nearer] + element.alpha * (v_[nearer] - base_.reference)),
          .traction_rate = element.modulus * (gradient(v_) + element.beta * gradient(motion_acceleration_)) +
                           mass_from_centre * (jerk_[nearer] + element.alpha * (motion_acceleration_[nearer] -
                                                                                reference_rate_)),
          .displacement = interpolate(u_)};
}

} // namespace tremolo::freefield
