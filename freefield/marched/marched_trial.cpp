// Fields that depend on t - s x have d/dx = -s d/dt. Zienkiewicz & Shiomi's equations in the form of two
// velocities (two_phase_column.cpp), excess over the state at rest, S = sigma' - p, q = n w:
//
//     d/dt [rho vx + rho_f qx + s Sxx] = d sxy/dy         d/dt [rho_f (vx + qx/n) - s p] = -(rho_f g/k) qx
//     d/dt [rho vy + rho_f qy + s sxy] = d Syy/dy         d/dt [rho_f (vy + qy/n)]       = -dp/dy - (rho_f
//     g/k) qy d exx = -s dvx,  d eyy = d(vy)/dy dt,  d gxy = d(vx)/dy dt - s dvy,   d sigma' = law(d exx, d
//     eyy, d gxy) dp = -(K_f/n) [d(vy + qy)/dy dt - s d(vx + qx)].
//
// Brackets at nodes (marched_node.hpp), stress at centres. From t to t + dt, the momenta P, R at t + dt/2
// known and X the increments of stress:
//
//     velocities at t + dt/2 from P, R and stress + X/2,   R' = R - dt d w,
//     velocities at t + dt   from P, R' and stress + X,    strain (element_strain.hpp),   X = law(strain);
//     then   P += dt F(stress),  R = R' + dt F~(p).
//
// At s = 0 the first line does not need X and this is the two-phase column. Small-strain damping is a viscous
// stress beta (G dvx/dy, M dvy/dy) in F alone: in proportion to the whole strain rate it would make the
// problem ill posed, since waves of high frequency would be post-critical.

#include "freefield/marched/marched_trial.hpp"

#include <algorithm>

namespace tremolo::freefield {
namespace {

using Eigen::Vector2d;

/// The loads of all nodes by the stresses of the elements.
void find_loads(const MarchedScheme& scheme, const WetGrid& grid, const std::vector<ElementStress>& stress,
                std::vector<NodeLoad>& loads) {
  loads.assign(grid.nodes.size(), {});
  for (std::size_t e = 0; e < stress.size(); ++e) {
    loads[e].add(grid.elements[e], stress[e], scheme.slowness, 1.0);
    loads[e + 1].add(grid.elements[e], stress[e], scheme.slowness, -1.0);
  }
}

} // namespace

MarchedTrial::MarchedTrial(const FeSoil& soil, const MarchedState& state)
    : soil_(&soil), soil_state_(state.soil), implicit_(state.velocity.size()), half_(state.velocity.size()),
      whole_(half_.size()), after_drag_(half_.size()), strain_(state.stress.size()), stress_(strain_.size()),
      excess_(strain_.size()), viscosity_(strain_.size()), viscous_(strain_.size(), Vector2d::Zero()),
      dexx_(strain_.size()), deyy_(strain_.size()), dgxy_(strain_.size()) {}

void MarchedTrial::begin(const MarchedScheme& scheme, const MarchedState& state, const BaseDrive& drive,
                         const std::vector<double>& moduli) {
  drive_ = drive;
  find_loads(scheme, state.grid, state.stress, before_);
  for (std::size_t i = 0; i < implicit_.size(); ++i)
    implicit_[i] =
        (Eigen::Matrix2d::Identity() + 0.5 * scheme.dt / state.grid.nodes[i].mass() * scheme.dashpots[i])
            .inverse();
  for (std::size_t e = 0; e < viscosity_.size(); ++e)
    viscosity_[e] = state.grid.elements[e].beta * moduli[e];
}

void MarchedTrial::evaluate(const MarchedScheme& scheme, const MarchedState& state,
                            const std::vector<double>& increment, std::vector<double>& residual) {
  for (std::size_t e = 0; e < stress_.size(); ++e) {
    const double* x = &increment[values * e];
    stress_[e] = {x[0], x[1], x[2], x[3]};
  }
  find_loads(scheme, state.grid, stress_, change_);
  find_velocities(scheme, state);
  find_strain(scheme, state);

  soil_state_ = state.soil;
  soil_->update(soil_state_, dexx_, deyy_, dgxy_);
  for (std::size_t e = 0; e < stress_.size(); ++e) {
    const WetElement& element = state.grid.elements[e];
    excess_[e] = state.excess[e] - element.stiffness * strain_[e].theta;
    const double pressure = element.stiffness > 0.0 ? std::max(excess_[e], element.lowest_excess) : 0.0;
    stress_[e] = {soil_->lateral(soil_state_, e), soil_->vertical(soil_state_, e),
                  soil_->shear(soil_state_, e), pressure};
    const double* x = &increment[values * e];
    double* r = &residual[values * e];
    r[0] = stress_[e].xx - state.stress[e].xx - x[0];
    r[1] = stress_[e].yy - state.stress[e].yy - x[1];
    r[2] = stress_[e].xy - state.stress[e].xy - x[2];
    r[3] = stress_[e].pressure - state.stress[e].pressure - x[3];
  }
}

void MarchedTrial::find_velocities(const MarchedScheme& scheme, const MarchedState& state) {
  const double dt = scheme.dt;
  for (std::size_t i = 0; i < half_.size(); ++i) {
    const WetNode& node = state.grid.nodes[i];
    NodeLoad load = before_[i];
    load.add(0.5, change_[i]);
    const NodeMomenta& momenta = state.momenta[i];
    const Vector2d fluid = momenta.fluid + Vector2d(load.lateral_pressure, 0.0);
    half_[i] = scheme.held(i) ? split_held(node, drive_.half, fluid, dt)
                              : split(node, momenta.mixture - load.lateral, fluid, dt);
    after_drag_[i] = momenta.fluid - dt * node.drag * half_[i].relative;
  }
  for (std::size_t e = 0; e < viscous_.size(); ++e) {
    const WetElement& element = state.grid.elements[e];
    const Vector2d rate = (half_[e + 1].solid - half_[e].solid) / element.length;
    viscous_[e] = viscosity_[e] * Vector2d(element.shear_ratio * rate.x(), rate.y());
  }
  for (std::size_t i = 0; i < whole_.size(); ++i) {
    const WetNode& node = state.grid.nodes[i];
    NodeLoad load = before_[i];
    load.add(1.0, change_[i]);
    const Vector2d fluid = after_drag_[i] + Vector2d(load.lateral_pressure, 0.5 * dt * load.fluid_force);
    if (scheme.held(i)) {
      whole_[i] = split_held(node, drive_.whole, fluid, 0.5 * dt);
      continue;
    }
    Vector2d force = load.force + viscous_force(i) + node.mass_damping * drive_.reference;
    if (i == 0)
      force += drive_.traction;
    const Vector2d momentum = state.momenta[i].mixture + 0.5 * dt * force - load.lateral;
    whole_[i] = split(node, implicit_[i] * momentum, fluid, 0.5 * dt);
  }
}

Vector2d MarchedTrial::viscous_force(std::size_t i) const {
  Vector2d force = Vector2d::Zero();
  if (i < viscous_.size())
    force += viscous_[i];
  if (i > 0)
    force -= viscous_[i - 1];
  return force;
}

void MarchedTrial::find_strain(const MarchedScheme& scheme, const MarchedState& state) {
  const auto move = [&](std::size_t i) {
    const double n = state.grid.nodes[i].porosity();
    const Vector2d change = whole_[i].solid - state.velocity[i].solid;
    return NodeMove{.vx = half_[i].solid.x(),
                    .vy = half_[i].solid.y(),
                    .qy = n * half_[i].relative.y(),
                    .dvx = change.x(),
                    .dvy = change.y(),
                    .dqx = n * (whole_[i].relative.x() - state.velocity[i].relative.x())};
  };
  NodeMove lower = move(0);
  for (std::size_t e = 0; e < strain_.size(); ++e) {
    const NodeMove upper = move(e + 1);
    strain_[e] = strain_of(state.grid.elements[e], lower, upper, scheme.slowness, scheme.dt);
    dexx_[e] = strain_[e].exx;
    deyy_[e] = strain_[e].eyy;
    dgxy_[e] = strain_[e].gxy;
    lower = upper;
  }
}

NodeLoad MarchedTrial::end_load(const MarchedState& state, std::size_t i, double slowness) const {
  NodeLoad load;
  if (i < stress_.size())
    load.add(state.grid.elements[i], stress_[i], slowness, 1.0);
  if (i > 0)
    load.add(state.grid.elements[i - 1], stress_[i - 1], slowness, -1.0);
  return load;
}

Vector2d MarchedTrial::internal_force(const MarchedState& state, std::size_t i) const {
  return end_load(state, i).force + viscous_force(i);
}

Vector2d MarchedTrial::total_force(const MarchedScheme& scheme, const MarchedState& state,
                                   std::size_t i) const {
  const WetNode& node = state.grid.nodes[i];
  Vector2d force = internal_force(state, i) - scheme.dashpots[i] * whole_[i].mean(node) +
                   node.mass_damping * drive_.reference;
  if (i == 0)
    force += drive_.traction;
  return force;
}

Vector2d MarchedTrial::bracket(const MarchedScheme& scheme, const MarchedState& state, std::size_t i) const {
  const WetNode& node = state.grid.nodes[i];
  return node.mass() * whole_[i].mean(node) + end_load(state, i, scheme.slowness).lateral;
}

void MarchedTrial::accept(const MarchedScheme& scheme, MarchedState& state) const {
  for (std::size_t i = 0; i < state.momenta.size(); ++i) {
    state.momenta[i].mixture += scheme.dt * total_force(scheme, state, i);
    state.momenta[i].fluid = after_drag_[i] + Vector2d(0.0, scheme.dt * fluid_force(state, i));
  }
  state.velocity = whole_;
  state.stress = stress_;
  state.excess = excess_;
  state.soil = soil_state_;
}

} // namespace tremolo::freefield
