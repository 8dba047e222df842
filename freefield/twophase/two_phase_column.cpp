// Zienkiewicz & Shiomi (1984), Int. J. Numer. Anal. Meth. Geomech. 8, 71-96, in the form of two velocities,
// grains incompressible, along the vertical y; excess over the state at rest:
//
//     (1-n) rho_s a_s + n rho_f a_f = d(sigma' - p)/dy,    rho_f a_f,y = -dp/dy - (n rho_f g/k) w_y,
//     dp/dt = -(K_f/n) d(v_s + n w)/dy,                    rho_f a_f,x = -(n rho_f g/k) w_x,
//
// sigma' = (sxy, syy) from the law, and of damping either beta C d eps/dt, C elastic in the present state of
// the law, or the stress of relaxation mechanisms (column_relaxation.hpp). With linear velocities and p
// constant in an element the second line is the dual of the first: w n, the flux, is what is continuous, and
// nothing flows at rest whatever n and k do. Central differences: from t to t + dt
//
//     u += dt v,    sigma' by the law,    p* -= dt Q d(v_s + n_I w)/h,    p = max(p*, p_cav - p_0),
//
// then the velocities by the forces at t + dt to t + 3/2 dt (node_kick.hpp). p* is not cut, so that a cavity
// closes before pressure rises again. Elements take their new lengths and porosities before the velocities
// (wet_grid.hpp). Excess is counted from the hydrostatic pressure at the place where the soil is now, under
// water that stands as high as at the start: the weight of grains less that of the water they displace does
// not change with strain, and gravity stays out of the equations.

#include "freefield/twophase/two_phase_column.hpp"

#include "base/require.hpp"
#include "freefield/twophase/step_limit.hpp"
#include "freefield/twophase/wet_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::freefield {
namespace {

constexpr long steps_between_checks = 16;

const Profile& checked(const Profile& profile, const TwoPhaseSettings& settings) {
  validate_march(profile, settings.damping, settings.time_step, settings.start_time);
  return profile;
}

} // namespace

double two_phase_step_limit(const Profile& profile, double max_element_size, const Damping& damping,
                            double growth) {
  RestingColumn rest = resting_column(profile, max_element_size, damping);
  for (double& modulus : rest.moduli)
    modulus *= growth;
  return step_limit(rest.grid, rest.moduli);
}

TwoPhaseColumn::TwoPhaseColumn(const Profile& profile, const TwoPhaseSettings& settings, InputVelocity input)
    : settings_(settings), mesh_(mesh_profile(checked(profile, settings), settings.max_element_size)),
      rise_(rise_to_damped_soil(profile)),
      grid_(wet_grid(profile, mesh_, settings.damping, settings.base == BaseKind::compliant)),
      soil_(profile, mesh_), relaxation_(profile, mesh_, settings.damping, settings.time_step),
      input_(std::move(input)), state_(soil_.initial()), u_(mesh_.node_y.size()), v_(u_.size()),
      before_(u_.size()), excess_(mesh_.elements()), deyy_(excess_.size()), dgxy_(excess_.size()),
      seen_exx_(excess_.size()), seen_eyy_(excess_.size()), seen_gxy_(excess_.size()), shear_(excess_.size()),
      vertical_(excess_.size()), pressure_(excess_.size()),
      lengths_(excess_.size()), snapshots_{WetSnapshot(mesh_.elements()), WetSnapshot(mesh_.elements()),
                                           WetSnapshot(mesh_.elements())} {
  if (!input_)
    throw std::invalid_argument("the column has no input motion");
  damped_ = std::ranges::any_of(grid_.elements, [](const WetElement& e) { return e.beta > 0.0; });
  if (settings_.base_pressure && grid_.elements.front().flows())
    grid_.nodes.front().sealed = false;
  soil_.p_moduli(state_, modulus_);
  const double limit = step_limit();
  require(settings_.time_step <= limit, "time step of the column", settings_.time_step,
          "at most " + shortest(limit) + " s, the stability limit of central differences");
}

double TwoPhaseColumn::time() const {
  return settings_.start_time + static_cast<double>(steps_) * settings_.time_step;
}

void TwoPhaseColumn::step() {
  follow_clock(settings_.clock, time(), soil_, grid_);
  const double dt = settings_.time_step;
  for (std::size_t i = 0; i < u_.size(); ++i) {
    u_[i].x += dt * v_[i][0].solid;
    u_[i].y += dt * v_[i][1].solid;
  }
  ++steps_;
  strain_soil();
  press_water();
  stretch();
  before_ = v_;
  kick();
  remember();
  count_power();
  if (steps_ % steps_between_checks == 0) {
    require_pores(grid_, mesh_, time());
    soil_.p_moduli(state_, modulus_);
    require_stable(settings_.time_step, step_limit(), time());
  }
}

double TwoPhaseColumn::step_limit() const {
  return freefield::step_limit(grid_, relaxation_.unrelaxed(modulus_));
}

void TwoPhaseColumn::strain_soil() {
  const double dt = settings_.time_step;
  for (std::size_t e = 0; e < deyy_.size(); ++e) {
    const double scale = dt / grid_.elements[e].length;
    dgxy_[e] = scale * (v_[e + 1][0].solid - v_[e][0].solid);
    deyy_[e] = scale * (v_[e + 1][1].solid - v_[e][1].solid);
    const InPlane seen = relaxation_.seen(e)({.yy = deyy_[e], .xy = dgxy_[e]});
    seen_exx_[e] = seen.xx;
    seen_eyy_[e] = seen.yy;
    seen_gxy_[e] = seen.xy;
  }
  sxx_before_ = state_.sxx;
  syy_before_ = state_.syy;
  sxy_before_ = state_.sxy;
  soil_.update(state_, seen_exx_, seen_eyy_, seen_gxy_);
  if (damped_)
    soil_.degraded_moduli(state_, degraded_);
  for (std::size_t e = 0; e < deyy_.size(); ++e) {
    const WetElement& element = grid_.elements[e];
    relaxation_.advance(
        e, {state_.sxx[e] - sxx_before_[e], state_.syy[e] - syy_before_[e], state_.sxy[e] - sxy_before_[e]});
    const InPlane relaxing = relaxation_.stress(e);
    double shear = soil_.shear(state_, e) + relaxing.xy;
    double vertical = soil_.vertical(state_, e) + relaxing.yy;
    if (damped_) {
      const double viscosity = element.beta * degraded_[e] / dt;
      shear += viscosity * element.shear_ratio * dgxy_[e];
      vertical += viscosity * deyy_[e];
    }
    count_strain(e, shear, vertical);
    shear_[e] = shear;
    vertical_[e] = vertical;
  }
}

void TwoPhaseColumn::press_water() {
  const double dt = settings_.time_step;
  const auto flux = [&](std::size_t i) {
    return grid_.nodes[i].porosity() * (v_[i][1].fluid - v_[i][1].solid);
  };
  for (std::size_t e = 0; e < excess_.size(); ++e) {
    const WetElement& element = grid_.elements[e];
    if (element.stiffness == 0.0)
      continue;
    double dilation = deyy_[e];
    if (element.flows())
      dilation += dt / element.length * (flux(e + 1) - flux(e));
    const double before = pressure_[e];
    excess_[e] -= element.stiffness * dilation;
    pressure_[e] = std::max(excess_[e], element.lowest_excess);
    spent_.pore -= 0.5 * (before + pressure_[e]) * element.length * dilation;
  }
}

void TwoPhaseColumn::stretch() {
  for (std::size_t e = 0; e < lengths_.size(); ++e)
    lengths_[e] = grid_.elements[e].length_at_rest + u_[e + 1].y - u_[e].y;
  set_lengths(grid_, lengths_);
}

Phases TwoPhaseColumn::kick_x(std::size_t i, double force) const {
  const WetNode& node = grid_.nodes[i];
  const double dt = settings_.time_step;
  if (i == 0 && settings_.base == BaseKind::rigid) {
    const double base = input_(time() + 0.5 * dt).x;
    return node.fluid > 0.0 ? kicked_by_base(node, v_[i][0], base, 0.0, dt) : Phases{base, base};
  }
  return node.fluid > 0.0 ? kicked_apart(node, v_[i][0], {force, 0.0}, node.dashpot_x, dt)
                          : kicked_together(node, v_[i][0], force, node.dashpot_x, dt);
}

Phases TwoPhaseColumn::kick_y(std::size_t i, const NodeForce& force) const {
  const WetNode& node = grid_.nodes[i];
  const double dt = settings_.time_step;
  const bool flows = node.fluid > 0.0 && !node.sealed;
  if (i == 0 && settings_.base == BaseKind::rigid) {
    const double base = input_(time() + 0.5 * dt).y;
    return flows ? kicked_by_base(node, v_[i][1], base, force.fluid, dt) : Phases{base, base};
  }
  return flows ? kicked_apart(node, v_[i][1], force, node.dashpot_y, dt)
               : kicked_together(node, v_[i][1], force.mixture, node.dashpot_y, dt);
}

/// Velocities half a step ahead of the present time, from those half a step behind and the present forces.
void TwoPhaseColumn::kick() {
  const std::size_t last = grid_.elements.size();
  reference_ = reference_velocity(settings_.base, input_, rise_, time());
  const Velocity incident = settings_.base == BaseKind::compliant ? input_(time()) : Velocity{};
  for (std::size_t i = 0; i <= last; ++i) {
    double fx = grid_.nodes[i].mass_damping * reference_.x;
    NodeForce fy{.mixture = grid_.nodes[i].mass_damping * reference_.y};
    if (i < last) {
      fx += shear_[i];
      fy.mixture += vertical_[i] - pressure_[i];
      fy.fluid -= grid_.elements[i].flows() ? pressure_[i] : 0.0;
    }
    if (i > 0) {
      fx -= shear_[i - 1];
      fy.mixture -= vertical_[i - 1] - pressure_[i - 1];
      fy.fluid += grid_.elements[i - 1].flows() ? pressure_[i - 1] : 0.0;
    }
    if (i == 0) {
      base_force_ = {shear_[0], vertical_[0] - pressure_[0]};
      fx += 2.0 * grid_.impedance_x * incident.x;
      fy.mixture += 2.0 * grid_.impedance_y * incident.y;
      if (settings_.base_pressure)
        fy.fluid += settings_.base_pressure(time());
    }
    if (i == last && settings_.surface_load)
      fy.mixture += settings_.surface_load(time());
    v_[i] = {kick_x(i, fx), kick_y(i, fy)};
  }
}

/// The present state, with velocity and acceleration from the velocities half a step before and after it.
void TwoPhaseColumn::remember() {
  std::rotate(snapshots_.begin(), snapshots_.end() - 1, snapshots_.end());
  WetSnapshot& now = snapshots_.front();
  now.reference = {reference_.x, reference_.y};
  const double per_step = 1.0 / settings_.time_step;
  double finite = 0.0; // a sum that is not finite if one of its terms is not
  for (std::size_t i = 0; i < u_.size(); ++i) {
    const auto& [x0, y0] = before_[i];
    const auto& [x1, y1] = v_[i];
    now.u[i] = u_[i];
    now.v[i] = {0.5 * (x0.solid + x1.solid), 0.5 * (y0.solid + y1.solid)};
    now.a[i] = {per_step * (x1.solid - x0.solid), per_step * (y1.solid - y0.solid)};
    now.a_fluid[i] = {per_step * (x1.fluid - x0.fluid), per_step * (y1.fluid - y0.fluid)};
    now.flux[i] = grid_.nodes[i].porosity() * (y1.fluid - y1.solid);
    now.flux_x[i] = 0.5 * grid_.nodes[i].porosity() * (x0.fluid - x0.solid + x1.fluid - x1.solid);
    finite += now.a[i].x + now.a[i].y + now.a_fluid[i].x + now.a_fluid[i].y;
  }
  if (!std::isfinite(finite)) {
    const Velocity input = input_(time());
    throw std::runtime_error("the motion of the free-field column is no longer finite; input velocity " +
                             shortest(input.x) + ", " + shortest(input.y) + " m/s");
  }
  for (std::size_t e = 0; e < excess_.size(); ++e) {
    const InPlane relaxing = relaxation_.stress(e);
    const double viscous = vertical_[e] - soil_.vertical(state_, e) - relaxing.yy;
    now.sxx[e] = soil_.lateral(state_, e) + relaxing.xx + grid_.elements[e].lateral_ratio * viscous;
    now.syy[e] = vertical_[e];
    now.sxy[e] = shear_[e];
    now.pressure[e] = pressure_[e];
  }
}

void TwoPhaseColumn::sample(std::span<const double> y, std::span<ColumnSample> samples) const {
  require_same_size(y, samples);
  const double scale = 0.5 / settings_.time_step;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const auto place = mesh_.at(y[i], from_below(y, i) ? ColumnMesh::Side::below : ColumnMesh::Side::above);
    const auto stress = [&](std::size_t age) { return stress_at(snapshots_[age], mesh_, grid_, place); };
    const std::array then = {stress(0), stress(1), stress(2)};
    const auto rate = [&](double WetStress::*component) {
      return scale * (3.0 * then[0].*component - 4.0 * then[1].*component + then[2].*component);
    };
    samples[i] = motion_at(snapshots_[0], mesh_, grid_, place);
    samples[i].sxx = then[0].sxx;
    samples[i].syy = then[0].syy;
    samples[i].sxy = then[0].sxy;
    samples[i].pore_pressure = then[0].pressure;
    samples[i].sxx_rate = rate(&WetStress::sxx);
    samples[i].syy_rate = rate(&WetStress::syy);
    samples[i].sxy_rate = rate(&WetStress::sxy);
  }
}

std::string TwoPhaseColumn::report() const {
  return fmt::format("{} steps of {:.4g} s", steps_, settings_.time_step) + missing_energy(energy());
}

} // namespace tremolo::freefield
