// Between nodes: velocity is linear; stress goes from where its cell has it to the level by the equation of
// motion of the nearer node, d tau/dy = rho f with f = dv/dt + alpha (v - v_ref) = (tau_i - tau_{i-1})/m_i.
// This makes it continuous from cell to cell and zero at the surface.

#include "freefield/ode/ode_polarisation.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tremolo::freefield {
namespace {

/// Steps within one served interval after which a column is taken for one that never gets there.
constexpr int most_steps = 100'000;

/// One a state variable: velocity (m/s), strain and its memory over the cell's wave speed, displacement over
/// a second.
std::vector<double> tolerances(const OdeSystem& system, const std::vector<OdeCell>& cells, double velocity) {
  std::vector<double> tolerance(system.size(), velocity);
  for (std::size_t e = 0; e < cells.size(); ++e)
    for (std::size_t i = system.strain_index(e); i < system.velocity_index(e + 1); ++i)
      tolerance[i] = velocity * std::sqrt(cells[e].density / cells[e].modulus);
  return tolerance;
}

/// Level of each state variable, m.
std::vector<double> levels(const OdeSystem& system, const StaggeredGrid& grid) {
  std::vector<double> y = {grid.mesh.node_y.front()};
  for (std::size_t e = 0; e < grid.mesh.elements(); ++e) {
    y.resize(system.velocity_index(e + 1), grid.stress_y[e]);
    y.push_back(grid.mesh.node_y[e + 1]);
  }
  return y;
}

} // namespace

OdePolarisation::OdePolarisation(StaggeredGrid grid, std::vector<OdeCell> cells, OdeBase base, OdeSoil soil,
                                 const OdeColumnSettings& settings)
    : grid_(std::move(grid)), cells_(std::move(cells)), system_(cells_, std::move(base), std::move(soil)),
      settings_(settings), time_(settings.start_time), state_(system_.size()), rate_(system_.size()),
      displacement_(grid_.mesh.node_y.size()) {}

/// The input is looked at in a quarter of the longest step, at times that do not depend on those served.
bool OdePolarisation::is_at_rest_until(double time) {
  const double interval = 0.25 * settings_.max_step;
  const auto look = [&](long i) { return settings_.start_time + static_cast<double>(i) * interval; };
  while (!integrator_ && look(quiet_) < time) {
    if (system_.input_velocity(look(quiet_ + 1)) == 0.0) {
      ++quiet_;
      continue;
    }
    settings_.start_time = look(quiet_);
    integrator_ = std::make_unique<OdeIntegrator>(system_, settings_,
                                                  tolerances(system_, cells_, settings_.absolute_tolerance),
                                                  levels(system_, grid_));
  }
  return !integrator_;
}

void OdePolarisation::serve(double time) {
  if (is_at_rest_until(time)) {
    time_ = time;
    return;
  }
  for (int steps = 0; integrator_->time() < time; ++steps) {
    if (steps == most_steps) {
      throw std::runtime_error("the column needs more than " + std::to_string(most_steps) +
                               " steps to get from t = " + shortest(time_) + " to " + shortest(time) +
                               " s: it is too stiff for its method (bdf suits any stiff column, imex stiff "
                               "damping) or the tolerance too tight");
    }
    integrator_->step();
  }
  time_ = time;
  integrator_->state(time, 0, state_);
  integrator_->state(time, 1, rate_);
  displacement_[0] = state_[0];
  for (std::size_t e = 0; e < cells_.size(); ++e)
    displacement_[e + 1] = displacement_[e] + cells_[e].length * state_[system_.strain_index(e)];
}

double OdePolarisation::strain_at(const ColumnMesh::Place& place, double y) const {
  const auto [lower, upper, weight] = grid_.mesh.centres(place);
  const double below = state_[system_.strain_index(lower)];
  if (lower == upper)
    return below;
  const double above = state_[system_.strain_index(upper)];
  return std::lerp(below, above,
                   (y - grid_.stress_y[lower]) / (grid_.stress_y[upper] - grid_.stress_y[lower]));
}

OdePolarisation::Sample OdePolarisation::at(double y, ColumnMesh::Side side) const {
  const ColumnMesh::Place place = grid_.mesh.at(y, side);
  const std::size_t e = place.element;
  const std::size_t nearer = e > 0 && place.fraction < 0.5 ? e : e + 1; // the base has no mass
  const auto motion = [&](std::size_t node) { return system_.motion(time_, state_, rate_, node); };
  const auto stress = [&](std::size_t cell) {
    return cell < cells_.size() ? system_.stress(time_, state_, rate_, cell) : OdeSystem::Stress{};
  };
  const auto under = stress(nearer - 1);
  const auto over = stress(nearer);
  const auto& own = nearer == e ? over : under;
  // Mass between the level and the cell's stress over the node's.
  const double share = cells_[e].density * (y - grid_.stress_y[e]) / system_.mass(nearer);
  const auto below = motion(e);
  const auto above = motion(e + 1);
  return {.velocity = std::lerp(below.velocity, above.velocity, place.fraction),
          .acceleration = std::lerp(below.acceleration, above.acceleration, place.fraction),
          .stress = own.value + share * (over.value - under.value),
          .stress_rate = own.rate + share * (over.rate - under.rate),
          .displacement = std::lerp(displacement_[e], displacement_[e + 1], place.fraction),
          .strain = strain_at(place, y),
          .layer = grid_.mesh.element_layer[e]};
}

} // namespace tremolo::freefield
