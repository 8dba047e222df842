// Central differences as in scalar_column.cpp; the soil's update replaces K u. Between element centres:
//
//     stress on horizontal faces: from the centre with d tau/dy = rho (a + alpha (v - v_ref)) of the nearer
//     node, v_ref of base_motion.hpp;
//     sxx: lambda/M syy, and what yield adds to it at the centres, interpolated;
//     strain: interpolated between centres.
//
// Rates of the soil's stress are differences over the last three states, (3 s - 4 s_1 + s_2)/(2 dt).

#include "freefield/fe/fe_nonlinear.hpp"

#include "base/require.hpp"
#include "freefield/fe/fe_linear.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::freefield {
namespace {

constexpr int most_halvings = 10;

double at_centres(const ColumnMesh::Centres& c, double lower, double upper) {
  return (1.0 - c.weight) * lower + c.weight * upper;
}

} // namespace

NonlinearColumn::NonlinearColumn(const Profile& profile, const ColumnMesh& mesh,
                                 const FeColumnSettings& settings)
    : mesh_(mesh), settings_(settings), rise_(rise_to_damped_soil(profile)),
      elements_(profile, mesh, settings.damping, settings.base), soil_(profile, mesh),
      newton_(settings.hht_alpha, settings.tangent, settings.newton_tolerance),
      state_(elements_.freedoms(), soil_.initial()), before_(elements_.freedoms()), du_(elements_.freedoms()),
      deyy_(elements_.count()), dgxy_(elements_.count()), acceleration_(elements_.freedoms()),
      jerk_(elements_.freedoms()) {
  centre_stress_.fill(centre_stress());
  if (settings.integrator == Integrator::central_difference)
    require_stable(settings.time_step, central_difference_limit(profile, mesh, settings.damping));
}

void NonlinearColumn::step(const InputVelocity& input, double time) {
  const BaseMotion base_before = state_.base;
  if (settings_.integrator == Integrator::newmark)
    step_implicit(input, time, settings_.time_step, 0);
  else
    step_explicit(input, time);
  const double per_step = 1.0 / settings_.time_step;
  reference_rate_ = {(state_.base.x.reference - base_before.x.reference) * per_step,
                     (state_.base.y.reference - base_before.y.reference) * per_step};
  double finite = 0.0; // a sum that is not finite if one of its terms is not
  for (std::size_t i = 0; i < acceleration_.size(); ++i) {
    const double before = acceleration_[i];
    acceleration_[i] = i < elements_.prescribed() ? state_.a[i] : -state_.r[i] * elements_.inverse_mass()[i];
    jerk_[i] = (acceleration_[i] - before) * per_step;
    finite += acceleration_[i];
  }
  if (!std::isfinite(finite)) {
    throw std::runtime_error("the motion of the free-field column is no longer finite; input velocity " +
                             shortest(state_.base.x.velocity) + ", " + shortest(state_.base.y.velocity) +
                             " m/s");
  }
  remember();
}

void NonlinearColumn::step_explicit(const InputVelocity& input, double time) {
  const double dt = settings_.time_step;
  before_ = static_cast<const FeMotion&>(state_);
  state_.base = advanced(settings_.base, input, rise_, before_.base, time, dt);
  for (std::size_t i = 0; i < du_.size(); ++i) {
    state_.u[i] += dt * before_.v[i] + 0.5 * dt * dt * before_.a[i];
    state_.stress_velocity[i] = before_.v[i] + dt * before_.a[i];
    state_.v[i] += 0.5 * dt * before_.a[i];
  }
  hold_base(elements_, state_);
  for (std::size_t i = 0; i < du_.size(); ++i)
    du_[i] = state_.u[i] - before_.u[i];
  elements_.strains(du_, deyy_, dgxy_);
  soil_.update(state_.soil, deyy_, dgxy_);
  elements_.resistance(soil_, state_.soil, state_.stress_velocity, state_.v, state_.base, state_.r);
  for (std::size_t i = elements_.prescribed(); i < du_.size(); ++i) {
    const double half_dashpot = 0.5 * dt * elements_.dashpots()[i];
    state_.a[i] = -state_.r[i] / (elements_.mass()[i] + half_dashpot);
    state_.v[i] += 0.5 * dt * state_.a[i];
    state_.r[i] += half_dashpot * state_.a[i];
  }
  account(before_, dt);
}

void NonlinearColumn::step_implicit(const InputVelocity& input, double time, double dt, int halvings) {
  FeState end = state_;
  end.base = advanced(settings_.base, input, rise_, state_.base, time, dt);
  if (newton_.step(elements_, soil_, state_, dt, largest_traction_, end)) {
    std::swap(state_, end);
    account(end, dt);
    return;
  }
  const std::size_t worst = newton_.worst_element();
  if (halvings == most_halvings) {
    throw std::runtime_error(
        "Newton's method does not converge in the free-field column even in a step of " + shortest(dt) +
        " s: element " + std::to_string(worst + 1) + " of " + std::to_string(mesh_.elements()) +
        " from the base, at a depth of " +
        shortest(mesh_.node_y.back() - 0.5 * (mesh_.node_y[worst] + mesh_.node_y[worst + 1])) + " m, time " +
        shortest(time) + " s; a smaller time step or central differences may help");
  }
  ++halved_;
  step_implicit(input, time, 0.5 * dt, halvings + 1);
  step_implicit(input, time + 0.5 * dt, 0.5 * dt, halvings + 1);
}

/// Work and dissipation of a step, as in ScalarColumn::account.
void NonlinearColumn::account(const FeMotion& before, double dt) {
  const auto mean_velocity = [&](std::size_t i) { return 0.5 * (before.v[i] + state_.v[i]); };
  if (elements_.prescribed() > 0) {
    for (std::size_t i = 0; i < 2; ++i) {
      base_work_ += 0.5 * (before.r[i] + state_.r[i]) * (state_.u[i] - before.u[i]) +
                    0.5 * elements_.mass()[i] * (state_.v[i] * state_.v[i] - before.v[i] * before.v[i]);
    }
  } else {
    const Velocity t0 = elements_.base_traction(before.v, before.base);
    const Velocity t1 = elements_.base_traction(state_.v, state_.base);
    base_work_ += 0.5 * dt * ((t0.x + t1.x) * mean_velocity(0) + (t0.y + t1.y) * mean_velocity(1));
  }
  const std::array reference{0.5 * (before.base.x.reference + state_.base.x.reference),
                             0.5 * (before.base.y.reference + state_.base.y.reference)};
  for (std::size_t i = 0; i < elements_.freedoms(); ++i) {
    const double relative = mean_velocity(i) - reference[i % 2];
    damping_ += dt * elements_.mass_damping()[i] * relative * relative;
    base_work_ -= dt * elements_.mass_damping()[i] * relative * reference[i % 2];
  }
  for (std::size_t e = 0; e < elements_.count(); ++e) {
    const FeElement& element = elements_[e];
    if (element.damping_time == 0.0)
      continue;
    for (const std::size_t c : {std::size_t{0}, std::size_t{1}}) {
      const double difference = mean_velocity(2 * e + 2 + c) - mean_velocity(2 * e + c);
      const double viscosity = c == 0 ? element.shear_viscosity : element.dilation_viscosity;
      damping_ += dt * viscosity / element.length * difference * difference;
    }
  }
}

NonlinearColumn::CentreStress NonlinearColumn::centre_stress() const {
  CentreStress stress;
  const std::size_t n = elements_.count();
  stress.sxx.resize(n);
  stress.syy.resize(n);
  stress.sxy.resize(n);
  for (std::size_t e = 0; e < n; ++e) {
    stress.sxx[e] = soil_.lateral(state_.soil, e);
    stress.syy[e] = soil_.vertical(state_.soil, e);
    stress.sxy[e] = soil_.shear(state_.soil, e);
  }
  return stress;
}

void NonlinearColumn::remember() {
  std::rotate(centre_stress_.rbegin(), centre_stress_.rbegin() + 1, centre_stress_.rend());
  CentreStress& now = centre_stress_[0];
  for (std::size_t e = 0; e < elements_.count(); ++e) {
    now.sxx[e] = soil_.lateral(state_.soil, e);
    now.syy[e] = soil_.vertical(state_.soil, e);
    now.sxy[e] = soil_.shear(state_.soil, e);
    largest_traction_ = std::max({largest_traction_, std::abs(now.syy[e]), std::abs(now.sxy[e])});
  }
}

double NonlinearColumn::stress_rate(std::vector<double> CentreStress::*component, std::size_t e) const {
  const auto [now, before, long_before] =
      std::array{(centre_stress_[0].*component)[e], (centre_stress_[1].*component)[e],
                 (centre_stress_[2].*component)[e]};
  return (3.0 * now - 4.0 * before + long_before) / (2.0 * settings_.time_step);
}

double NonlinearColumn::gradient(const std::vector<double>& nodal, std::size_t e,
                                 std::size_t component) const {
  return (nodal[2 * e + 2 + component] - nodal[2 * e + component]) / elements_[e].length;
}

ColumnSample NonlinearColumn::sample(const ColumnMesh::Place& place) const {
  const ColumnMesh::Centres centres = mesh_.centres(place);
  const auto interpolated = [&](const std::vector<double>& nodal, std::size_t component) {
    const std::size_t first = 2 * place.element + component;
    return std::lerp(nodal[first], nodal[first + 2], place.fraction);
  };
  const auto strain = [&](std::size_t component) {
    return at_centres(centres, gradient(state_.u, centres.lower, component),
                      gradient(state_.u, centres.upper, component));
  };
  ColumnSample sample;
  sample.vx = interpolated(state_.v, 0);
  sample.vy = interpolated(state_.v, 1);
  sample.vx_rate = interpolated(acceleration_, 0);
  sample.vy_rate = interpolated(acceleration_, 1);
  sample.ux = interpolated(state_.u, 0);
  sample.uy = interpolated(state_.u, 1);
  sample.gxy = strain(0);
  sample.eyy = strain(1);
  sample_stress(place, centres, sample);
  return sample;
}

void NonlinearColumn::sample_stress(const ColumnMesh::Place& place, const ColumnMesh::Centres& centres,
                                    ColumnSample& sample) const {
  const std::size_t e = place.element;
  const FeElement& element = elements_[e];
  const CentreStress& now = centre_stress_[0];
  const std::size_t nearer = 2 * (place.fraction < 0.5 ? e : e + 1);
  const double mass_from_centre = element.density * element.length * (place.fraction - 0.5);
  const std::array reference{state_.base.x.reference, state_.base.y.reference};
  const auto traction = [&](double soil, double viscosity, std::size_t c) {
    return soil + viscosity * gradient(state_.stress_velocity, e, c) +
           mass_from_centre *
               (acceleration_[nearer + c] + element.alpha * (state_.v[nearer + c] - reference[c]));
  };
  const auto traction_rate = [&](double soil, double viscosity, std::size_t c) {
    return soil + viscosity * gradient(acceleration_, e, c) +
           mass_from_centre *
               (jerk_[nearer + c] + element.alpha * (acceleration_[nearer + c] - reference_rate_[c]));
  };
  const auto yielded = [&](std::size_t i) { return now.sxx[i] - elements_[i].lateral_ratio * now.syy[i]; };
  const auto yielded_rate = [&](std::size_t i) {
    return stress_rate(&CentreStress::sxx, i) -
           elements_[i].lateral_ratio * stress_rate(&CentreStress::syy, i);
  };
  sample.sxy = traction(now.sxy[e], element.shear_viscosity, 0);
  sample.syy = traction(now.syy[e], element.dilation_viscosity, 1);
  sample.sxx = element.lateral_ratio * sample.syy +
               at_centres(centres, yielded(centres.lower), yielded(centres.upper));
  sample.sxy_rate = traction_rate(stress_rate(&CentreStress::sxy, e), element.shear_viscosity, 0);
  sample.syy_rate = traction_rate(stress_rate(&CentreStress::syy, e), element.dilation_viscosity, 1);
  sample.sxx_rate = element.lateral_ratio * sample.syy_rate +
                    at_centres(centres, yielded_rate(centres.lower), yielded_rate(centres.upper));
}

ColumnEnergy NonlinearColumn::energy() const {
  ColumnEnergy energy{.damping = damping_, .base_work = base_work_};
  for (std::size_t i = 0; i < elements_.freedoms(); ++i)
    energy.kinetic += 0.5 * elements_.mass()[i] * state_.v[i] * state_.v[i];
  for (std::size_t e = 0; e < elements_.count(); ++e) {
    const double length = elements_[e].length;
    const double eyy = (state_.u[2 * e + 3] - state_.u[2 * e + 1]) / length;
    energy.strain += length * soil_.elastic_energy(state_.soil, e, eyy);
    energy.plastic += length * state_.soil.plastic_work[e];
  }
  return energy;
}

} // namespace tremolo::freefield
