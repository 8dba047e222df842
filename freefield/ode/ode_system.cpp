// Per m2 of plan area, nodes i of mass m_i (half of the cells beside it), cells e of length l_e between nodes
// e and e + 1, tau_n = 0 at the free surface:
//
//     de_e/dt = (v_{e+1} - v_e)/l_e,   m_i (dv_i/dt + alpha_i (v_i - v_ref)) = tau_i - tau_{i-1},
//     tau_e = sigma(e_e) + E beta de_e/dt,   v_ref of base_motion.hpp.
//
// Under constant damping, with c = G_R/G, w_j and tau_j of materials/relaxation/relaxation.cpp, a mechanism's
// stress is w_j (sigma - E a_j), so that the right-hand side has no jump where the tangent has:
//
//     tau_e = (1 + sum w_j) sigma(c e_e) - E sum w_j a_j,   da_j/dt = (sigma(c e_e)/E - a_j)/tau_j.
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
#include <numeric>

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
  for (const OdeCell& cell : cells_)
    stride_ = std::max(stride_, 2 + cell.relaxation.time.size());
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
  const double seen = cells_[cell].relaxation.relaxed;
  return is_nonlinear(cell) ? soil_.stress(soil_index_[cell], time, seen * strain, seen * strain_rate)
                            : cells_[cell].modulus * seen * strain;
}

double OdeSystem::stress_with(State y, std::size_t cell, double soil_stress) const {
  const auto& [relaxed, time, weight] = cells_[cell].relaxation;
  double stress = soil_stress;
  for (std::size_t j = 0; j < weight.size(); ++j)
    stress += weight[j] * (soil_stress - cells_[cell].modulus * y[memory_index(cell, j)]);
  return stress;
}

double OdeSystem::stress_rate(double time, State y, State y_rate, std::size_t cell) const {
  return stress_with(y_rate, cell, soil_tangent(time, y, cell) * y_rate[strain_index(cell)]);
}

void OdeSystem::remember(State y, std::size_t cell, double soil_stress, Derivative rate) const {
  const auto& times = cells_[cell].relaxation.time;
  for (std::size_t j = 0; j + 2 < stride_; ++j) {
    const std::size_t i = memory_index(cell, j);
    rate[i] = j < times.size() ? (soil_stress / cells_[cell].modulus - y[i]) / times[j] : 0.0;
  }
}

double OdeSystem::strain_rate(double time, State y, std::size_t cell) const {
  // Whether the lowest cell has turned back is judged by the rate that it has if it did not.
  const double below =
      cell == 0 ? base_velocity(time, y, stress_with(y, 0, soil_stress(time, 0, y[strain_index(0)], 0.0)))
                : y[velocity_index(cell)];
  return (y[velocity_index(cell + 1)] - below) / cells_[cell].length;
}

double OdeSystem::lowest_soil_stress(double time, State y) const {
  return soil_stress(time, 0, y[strain_index(0)], is_nonlinear(0) ? strain_rate(time, y, 0) : 0.0);
}

void OdeSystem::march(double time, State y, Derivative rate, double damping) const {
  const double lowest_soil = lowest_soil_stress(time, y);
  const double lowest = stress_with(y, 0, lowest_soil);
  const double reference = drags_ ? base_.reference(time) : 0.0;
  double below = base_velocity(time, y, lowest);
  double above = y[velocity_index(1)];
  double stress = lowest + viscosity(0) * (damping * above - undamped_base_velocity(time, lowest));
  rate[0] = below;
  rate[strain_index(0)] = (above - below) / cells_[0].length;
  remember(y, 0, lowest_soil, rate);
  for (std::size_t e = 1; e < cells_.size(); ++e) {
    below = above;
    above = y[velocity_index(e + 1)];
    const double strain_rate = (above - below) / cells_[e].length;
    const double stress_below = stress;
    const double soil = soil_stress(time, e, y[strain_index(e)], strain_rate);
    stress = stress_with(y, e, soil) + damping * cells_[e].modulus * cells_[e].beta * strain_rate;
    rate[strain_index(e)] = strain_rate;
    remember(y, e, soil, rate);
    rate[velocity_index(e)] = (stress - stress_below) / mass_[e] - alpha_[e] * (below - reference);
  }
  rate[velocity_index(cells_.size())] = -stress / mass_.back() - alpha_.back() * (above - reference);
}

void OdeSystem::damping_part(State y, Derivative rate) const {
  std::ranges::fill(rate, 0.0);
  double above = y[velocity_index(1)];
  double stress = viscosity(0) * above;
  for (std::size_t e = 1; e < cells_.size(); ++e) {
    const double below = above;
    above = y[velocity_index(e + 1)];
    const double stress_below = stress;
    stress = viscosity(e) * (above - below);
    rate[velocity_index(e)] = (stress - stress_below) / mass_[e];
  }
  rate[velocity_index(cells_.size())] = -stress / mass_.back();
}

double OdeSystem::soil_tangent(double time, State y, std::size_t cell) const {
  const double seen = cells_[cell].relaxation.relaxed;
  return seen * (is_nonlinear(cell) ? soil_
                                          .response(soil_index_[cell], time, seen * y[strain_index(cell)],
                                                    seen * strain_rate(time, y, cell))
                                          .tangent
                                    : cells_[cell].modulus);
}

void OdeSystem::jacobian(double time, State y, const Entry& entry) const {
  const double damped = 1.0 + base_ratio_;
  const bool compliant = base_.kind == BaseKind::compliant;
  const double base_by_stress = compliant ? 1.0 / (base_.impedance * damped) : 0.0;
  const double base_by_velocity = base_ratio_ / damped;
  entry(0, velocity_index(1), base_by_velocity);
  entry(strain_index(0), velocity_index(1), (1.0 - base_by_velocity) / cells_[0].length);
  for (std::size_t e = 1; e < cells_.size(); ++e) {
    entry(strain_index(e), velocity_index(e), -1.0 / cells_[e].length);
    entry(strain_index(e), velocity_index(e + 1), 1.0 / cells_[e].length);
  }
  for (std::size_t e = 0; e < cells_.size(); ++e) {
    const auto& [relaxed, times, weight] = cells_[e].relaxation;
    const double soil = soil_tangent(time, y, e);
    const auto stress_by = [&](std::size_t column, double value) {
      // tau_0 depends on its cell through the base's velocity too.
      const double force = e == 0 ? value / damped : value;
      entry(velocity_index(e + 1), column, -force / mass_[e + 1]);
      if (e > 0) {
        entry(velocity_index(e), column, force / mass_[e]);
      } else {
        entry(0, column, base_by_stress * value);
        entry(strain_index(0), column, -base_by_stress * value / cells_[0].length);
      }
    };
    stress_by(strain_index(e), soil * std::accumulate(weight.begin(), weight.end(), 1.0));
    for (std::size_t j = 0; j < weight.size(); ++j) {
      stress_by(memory_index(e, j), -cells_[e].modulus * weight[j]);
      entry(memory_index(e, j), strain_index(e), soil / (cells_[e].modulus * times[j]));
      entry(memory_index(e, j), memory_index(e, j), -1.0 / times[j]);
    }
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
    const double seen = cells_[cell].relaxation.relaxed;
    strain_[i] = seen * y[strain_index(cell)];
    rate_[i] = seen * strain_rate(time, y, cell);
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
  const double undamped =
      base_.kind == BaseKind::rigid ? input : 2.0 * input + stress_rate(time, y, y_rate, 0) / base_.impedance;
  return {base_velocity(time, y, stress_with(y, 0, lowest_soil_stress(time, y))),
          (undamped + base_ratio_ * y_rate[velocity_index(1)]) / (1.0 + base_ratio_)};
}

OdeSystem::Stress OdeSystem::stress(double time, State y, State y_rate, std::size_t cell) const {
  const double strain = y[strain_index(cell)];
  const double soil =
      cell == 0 ? lowest_soil_stress(time, y) : soil_stress(time, cell, strain, strain_rate(time, y, cell));
  const Motion below = motion(time, y, y_rate, cell);
  const Motion above = motion(time, y, y_rate, cell + 1);
  const double viscosity = cells_[cell].modulus * cells_[cell].beta / cells_[cell].length;
  return {stress_with(y, cell, soil) + viscosity * (above.velocity - below.velocity),
          stress_rate(time, y, y_rate, cell) + viscosity * (above.acceleration - below.acceleration)};
}

} // namespace tremolo::freefield
