// Per m2 of plan area, nodes i of mass m_i (half of the cells beside it), cells e of length l_e between nodes
// e and e + 1, tau_n = 0 at the free surface:
//
//     de_e/dt = (v_{e+1} - v_e)/l_e,   m_i (dv_i/dt + alpha_i (v_i - v_ref)) = tau_i - tau_{i-1},
//     tau_e = sigma(e_e) + E beta de_e/dt,   v_ref of base_motion.hpp.
//
// The strain is the unknown and the stress follows from it. With the stress as the unknown, dtau/dt = E_t
// de/dt, the right-hand side would jump wherever the tangent E_t does; sigma(e) has kinks there only, and
// none in time at a reversal, where de/dt passes through zero.
//
// Base velocity v_0 = v_b: prescribed if rigid. Over a half-space of impedance Z the stress at the base is
// that of the incident and the outgoing wave, tau_0 = Z (v_b - 2 v_inc) (Joyner and Chen 1975, BSSA 65(5),
// 1315-1336). With tau_0 = sigma_0 + (E beta/l)_0 (v_1 - v_b) and r = (E beta/l)_0 / Z,
//
//     v_b = (w + r v_1)/(1 + r),   w = 2 v_inc + sigma_0/Z,
//     tau_0 = sigma_0 + (E beta/l)_0 (v_1 - w)/(1 + r);
//
// rigid: r = 0 and w = v_inc in the same formulas.

#include "freefield/ode/ode_system.hpp"

#include <algorithm>

namespace tremolo::freefield {

OdeSystem::OdeSystem(std::vector<OdeCell> cells, OdeBase base, OdeSoil soil)
    : cells_(std::move(cells)), base_(std::move(base)), soil_(std::move(soil)),
      soil_index_(cells_.size(), soil_.cells().size()), mass_(cells_.size() + 1), alpha_(mass_.size()),
      strain_(soil_.cells().size()), rate_(soil_.cells().size()) {
  for (std::size_t i = 0; i < soil_.cells().size(); ++i)
    soil_index_[soil_.cells()[i].index] = i;
  for (std::size_t e = 0; e < cells_.size(); ++e) {
    const OdeCell& cell = cells_[e];
    const double half_mass = 0.5 * cell.density * cell.length;
    // The base has no mass: that of the lowest cell over a compliant base is the upper node's.
    const bool half_cell = e == 0 && base_.kind == BaseKind::compliant;
    const double above = half_cell ? 2.0 * half_mass : half_mass;
    mass_[e + 1] += above;
    alpha_[e + 1] += above * cell.alpha;
    mass_[e] += half_mass;
    alpha_[e] += half_mass * cell.alpha;
  }
  for (std::size_t i = 0; i < mass_.size(); ++i)
    alpha_[i] /= mass_[i];
  drags_ = std::ranges::any_of(alpha_, [](double alpha) { return alpha > 0.0; });
  if (base_.kind == BaseKind::compliant)
    base_ratio_ = cells_[0].modulus * cells_[0].beta / (cells_[0].length * base_.impedance);
}

double OdeSystem::viscosity(std::size_t cell) const {
  const double value = cells_[cell].modulus * cells_[cell].beta / cells_[cell].length;
  return cell == 0 ? value / (1.0 + base_ratio_) : value;
}

double OdeSystem::undamped_base_velocity(double time, double stress) const {
  const double input = base_.velocity(time);
  return base_.kind == BaseKind::rigid ? input : 2.0 * input + stress / base_.impedance;
}

double OdeSystem::base_velocity(double time, State y, double stress) const {
  return (undamped_base_velocity(time, stress) + base_ratio_ * y[velocity_index(1)]) / (1.0 + base_ratio_);
}

double OdeSystem::soil_stress(double time, std::size_t cell, double strain, double strain_rate) const {
  return is_nonlinear(cell) ? soil_.stress(soil_index_[cell], time, strain, strain_rate)
                            : cells_[cell].modulus * strain;
}

double OdeSystem::strain_rate(double time, State y, std::size_t cell) const {
  // Whether the lowest cell has turned back is judged by the rate that it has if it did not.
  const double below = cell == 0 ? base_velocity(time, y, soil_stress(time, 0, y[strain_index(0)], 0.0))
                                 : y[velocity_index(cell)];
  return (y[velocity_index(cell + 1)] - below) / cells_[cell].length;
}

double OdeSystem::lowest_stress(double time, State y) const {
  const double strain = y[strain_index(0)];
  return is_nonlinear(0) ? soil_stress(time, 0, strain, strain_rate(time, y, 0)) : cells_[0].modulus * strain;
}

void OdeSystem::march(double time, State y, Derivative rate, double damping) const {
  const double lowest = lowest_stress(time, y);
  const double reference = drags_ ? base_.reference(time) : 0.0;
  double below = base_velocity(time, y, lowest);
  double above = y[velocity_index(1)];
  double stress = lowest + viscosity(0) * (damping * above - undamped_base_velocity(time, lowest));
  rate[0] = below;
  rate[strain_index(0)] = (above - below) / cells_[0].length;
  for (std::size_t e = 1; e < cells_.size(); ++e) {
    below = above;
    above = y[velocity_index(e + 1)];
    const double strain_rate = (above - below) / cells_[e].length;
    const double stress_below = stress;
    stress = soil_stress(time, e, y[strain_index(e)], strain_rate) +
             damping * cells_[e].modulus * cells_[e].beta * strain_rate;
    rate[strain_index(e)] = strain_rate;
    rate[velocity_index(e)] = (stress - stress_below) / mass_[e] - alpha_[e] * (below - reference);
  }
  rate[velocity_index(cells_.size())] = -stress / mass_.back() - alpha_.back() * (above - reference);
}

void OdeSystem::damping_part(State y, Derivative rate) const {
  rate[0] = 0.0;
  double above = y[velocity_index(1)];
  double stress = viscosity(0) * above;
  rate[strain_index(0)] = 0.0;
  for (std::size_t e = 1; e < cells_.size(); ++e) {
    const double below = above;
    above = y[velocity_index(e + 1)];
    const double stress_below = stress;
    stress = viscosity(e) * (above - below);
    rate[strain_index(e)] = 0.0;
    rate[velocity_index(e)] = (stress - stress_below) / mass_[e];
  }
  rate[velocity_index(cells_.size())] = -stress / mass_.back();
}

double OdeSystem::tangent(double time, State y, std::size_t cell) const {
  return is_nonlinear(cell)
             ? soil_.response(soil_index_[cell], time, y[strain_index(cell)], strain_rate(time, y, cell))
                   .tangent
             : cells_[cell].modulus;
}

void OdeSystem::jacobian(double time, State y, const Entry& entry) const {
  const double damped = 1.0 + base_ratio_;
  const bool compliant = base_.kind == BaseKind::compliant;
  const double lowest = tangent(time, y, 0);
  const double base_by_strain = compliant ? lowest / (base_.impedance * damped) : 0.0;
  const double base_by_velocity = base_ratio_ / damped;
  entry(0, strain_index(0), base_by_strain);
  entry(0, velocity_index(1), base_by_velocity);
  entry(strain_index(0), strain_index(0), -base_by_strain / cells_[0].length);
  entry(strain_index(0), velocity_index(1), (1.0 - base_by_velocity) / cells_[0].length);
  for (std::size_t e = 1; e < cells_.size(); ++e) {
    entry(strain_index(e), velocity_index(e), -1.0 / cells_[e].length);
    entry(strain_index(e), velocity_index(e + 1), 1.0 / cells_[e].length);
  }
  for (std::size_t e = 0; e < cells_.size(); ++e) {
    // tau_0 depends on the strain of its cell through the base's velocity too.
    const double stress_by_strain = e == 0 ? lowest / damped : tangent(time, y, e);
    entry(velocity_index(e + 1), strain_index(e), -stress_by_strain / mass_[e + 1]);
    if (e > 0)
      entry(velocity_index(e), strain_index(e), stress_by_strain / mass_[e]);
    entry(velocity_index(e + 1), velocity_index(e + 1), -alpha_[e + 1]);
  }
  damping_jacobian(entry);
}

void OdeSystem::damping_jacobian(const Entry& entry) const {
  for (std::size_t e = 0; e < cells_.size(); ++e) {
    const std::size_t below = velocity_index(e);
    const std::size_t above = velocity_index(e + 1);
    entry(above, above, -viscosity(e) / mass_[e + 1]);
    if (e > 0) {
      entry(above, below, viscosity(e) / mass_[e + 1]);
      entry(below, above, viscosity(e) / mass_[e]);
      entry(below, below, -viscosity(e) / mass_[e]);
    }
  }
}

void OdeSystem::accept(double time, State y) {
  for (std::size_t i = 0; i < soil_.cells().size(); ++i) {
    const std::size_t cell = soil_.cells()[i].index;
    strain_[i] = y[strain_index(cell)];
    rate_[i] = strain_rate(time, y, cell);
  }
  soil_.accept(time, strain_, rate_);
}

double OdeSystem::input_acceleration(double time) const {
  constexpr double h = 1e-5; // s
  return (base_.velocity(time + h) - base_.velocity(time - h)) / (2.0 * h);
}

OdeSystem::Motion OdeSystem::motion(double time, State y, State y_rate, std::size_t node) const {
  if (node > 0)
    return {y[velocity_index(node)], y_rate[velocity_index(node)]};
  const double input = input_acceleration(time);
  const double soil_rate = tangent(time, y, 0) * y_rate[strain_index(0)];
  const double undamped = base_.kind == BaseKind::rigid ? input : 2.0 * input + soil_rate / base_.impedance;
  return {base_velocity(time, y, lowest_stress(time, y)),
          (undamped + base_ratio_ * y_rate[velocity_index(1)]) / (1.0 + base_ratio_)};
}

OdeSystem::Stress OdeSystem::stress(double time, State y, State y_rate, std::size_t cell) const {
  const double strain = y[strain_index(cell)];
  const double soil =
      cell == 0 ? lowest_stress(time, y) : soil_stress(time, cell, strain, strain_rate(time, y, cell));
  const Motion below = motion(time, y, y_rate, cell);
  const Motion above = motion(time, y, y_rate, cell + 1);
  const double viscosity = cells_[cell].modulus * cells_[cell].beta / cells_[cell].length;
  return {soil + viscosity * (above.velocity - below.velocity),
          tangent(time, y, cell) * y_rate[strain_index(cell)] +
              viscosity * (above.acceleration - below.acceleration)};
}

} // namespace tremolo::freefield
