// Strain between the accepted state (gamma_0, r_0) and the trial (gamma_1, r_1) a time h later, s in [0, 1]:
//
//     d gamma/ds = a s^2 + b s + c,   a = 3h (r_0 + r_1) - 6d,   b = 6d - h (4 r_0 + 2 r_1),   c = h r_0,
//
// d = gamma_1 - gamma_0. It is c at s = 0 and h r_1 at s = 1, so opposite signs there mean one root between.

#include "freefield/ode/ode_soil.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::freefield {

OdeSoil::OdeSoil(std::vector<Cell> cells)
    : cells_(std::move(cells)), history_(cells_.size(), History{}), strain_(cells_.size()),
      rate_(cells_.size()) {}

double OdeSoil::turning_strain(std::size_t i, double time, double strain, double strain_rate) const {
  const double h = time - time_;
  const double d = strain - strain_[i];
  const double a = 3.0 * h * (rate_[i] + strain_rate) - 6.0 * d;
  const double b = 6.0 * d - h * (4.0 * rate_[i] + 2.0 * strain_rate);
  const double c = h * rate_[i];
  const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(b * b - 4.0 * a * c, 0.0)), b));
  const double other = c / q;
  const double s = other >= 0.0 && other <= 1.0 ? other : std::clamp(q / a, 0.0, 1.0);
  return strain_[i] + s * (c + s * (b / 2.0 + s * a / 3.0));
}

OdeSoil::History OdeSoil::turned(std::size_t i, double time, double strain, double strain_rate) const {
  History history = history_[i];
  materials::masing_commit(cells_[i].backbone, history, turning_strain(i, time, strain, strain_rate));
  return history;
}

double OdeSoil::stress(std::size_t i, double time, double strain, double strain_rate) const {
  if (turns(i, time, strain_rate))
    return materials::masing_stress(cells_[i].backbone, turned(i, time, strain, strain_rate), strain);
  return materials::masing_stress(cells_[i].backbone, history_[i], strain);
}

materials::ShearResponse OdeSoil::response(std::size_t i, double time, double strain,
                                           double strain_rate) const {
  if (turns(i, time, strain_rate))
    return materials::masing_response(cells_[i].backbone, turned(i, time, strain, strain_rate), strain);
  return materials::masing_response(cells_[i].backbone, history_[i], strain);
}

void OdeSoil::accept(double time, std::span<const double> strain, std::span<const double> strain_rate) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (turns(i, time, strain_rate[i])) {
      const double turning = turning_strain(i, time, strain[i], strain_rate[i]);
      materials::masing_commit(cells_[i].backbone, history_[i], turning);
    }
    materials::masing_commit(cells_[i].backbone, history_[i], strain[i]);
    strain_[i] = strain[i];
    rate_[i] = strain_rate[i];
  }
  time_ = time;
}

} // namespace tremolo::freefield
