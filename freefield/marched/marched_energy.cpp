// The energy per area of a wave field that depends on t - s x (Aki & Richards 2002, sec. 5.4, for flux): at
// whole levels of the march, with a_s, a_f the accelerations of grains and water by F and F~,
//
//     E = sum_i (m_s v^2 + m_f v_f^2)/2 + s sum_e h [Sxx M vx + sxy M vy - p M qx] - dt^2/8 sum_i (m_s a_s^2
//     + m_f a_f^2)
//         + sum_e h (energy of the soil's stress + p^2 n/(2 K_f)),
//
// which elastic soil without drag keeps to rounding. The first line is booked as kinetic; the second by the
// work of stress and pressure on the strain of each step, by the trapezoidal rule. Drag is booked half a step
// ahead, where it acts, base and damping at whole levels. A law that sees a share of the strain has counted
// that share of the plastic work. The work of relaxation mechanisms is booked as damping.

#include "freefield/marched/marched_column.hpp"

#include <algorithm>

namespace tremolo::freefield {

using Eigen::Vector2d;

/// Books the trial step from the state, before it is accepted.
void MarchedColumn::count_work(const BaseDrive& drive) {
  const double dt = settings_.time_step;
  for (std::size_t e = 0; e < mesh_.elements(); ++e) {
    const double length = state_.grid.elements[e].length;
    const ElementStrain d = trial_.strain(e);
    const ElementStress& before = state_.stress[e];
    const ElementStress after = trial_.stress(e);
    const SoilState& rest = soil_.initial();
    const double gravity = length * (rest.sxx[e] * d.exx + rest.syy[e] * d.eyy);
    spent_.gravity += gravity;
    const double work =
        0.5 * length *
        ((before.xx + after.xx) * d.exx + (before.yy + after.yy) * d.eyy + (before.xy + after.xy) * d.gxy);
    const auto law_before = state_.law_stress.row(static_cast<Eigen::Index>(e));
    const InPlane law_after = trial_.law_stress(e);
    const double of_law = 0.5 * length *
                          ((law_before[0] + law_after.xx) * d.exx + (law_before[1] + law_after.yy) * d.eyy +
                           (law_before[2] + law_after.xy) * d.gxy);
    spent_.elastic += gravity + of_law;
    spent_.damping += work - of_law;
    spent_.pore -= 0.5 * length * (before.pressure + after.pressure) * d.theta;
    const Vector2d vertical = dt * (trial_.half(e + 1).solid - trial_.half(e).solid);
    spent_.damping += trial_.viscous(e).dot(vertical);
  }
  for (std::size_t i = 0; i < u_.size(); ++i) {
    const WetNode& node = state_.grid.nodes[i];
    spent_.drag += dt * node.porosity() * node.drag * trial_.half(i).relative.squaredNorm();
    if (scheme_.held(i))
      continue;
    const auto brake = [&](const NodeVelocity& v, const Vector2d& reference) {
      const Vector2d drag = node.mass_damping * (v.mean(node) - reference);
      spent_.damping += 0.5 * dt * drag.dot(v.solid - reference);
      spent_.base -= 0.5 * dt * drag.dot(reference);
    };
    brake(state_.velocity[i], drive_.reference);
    brake(trial_.whole(i), drive.reference);
  }
  count_base_work(drive);
}

/// The half-space gives the power of its traction at whole levels; a rigid base gives what its node takes to
/// move as it does, half a step ahead.
void MarchedColumn::count_base_work(const BaseDrive& drive) {
  const double dt = settings_.time_step;
  const Vector2d force = trial_.base_internal_force();
  std::rotate(base_bracket_.begin(), base_bracket_.end() - 1, base_bracket_.end());
  base_bracket_[0] = trial_.base_bracket();
  if (settings_.base == BaseKind::rigid) {
    const Vector2d impulse = base_bracket_[0] - base_bracket_[1] - 0.5 * dt * (base_force_ + force);
    spent_.base += impulse.dot(trial_.half(0).solid);
    base_force_ = force;
    return;
  }
  const WetNode& node = state_.grid.nodes.front();
  const NodeVelocity velocity = trial_.whole(0);
  const Vector2d traction =
      trial_.force(0) - force + node.mass_damping * (velocity.mean(node) - drive.reference);
  const double power = traction.dot(velocity.solid);
  spent_.base += 0.5 * dt * (base_power_ + power);
  base_power_ = power;
}

double MarchedColumn::kinetic_energy() const {
  const MarchedSnapshot& now = snapshots_.front();
  const double dt = settings_.time_step;
  double energy = 0.0;
  for (std::size_t i = 0; i < u_.size(); ++i) {
    const WetNode& node = state_.grid.nodes[i];
    const NodeVelocity& v = now.velocity[i];
    const Vector2d water = v.solid + v.relative;
    // Forces set the water in motion where it can pass, the grains everywhere.
    Vector2d a_fluid = node.fluid > 0.0 ? Vector2d(0.0, now.fluid_force[i] / node.full) : Vector2d::Zero();
    Vector2d a_solid = (now.force[i] - node.fluid * a_fluid) / node.solid;
    if (node.sealed)
      a_solid.y() = a_fluid.y() = now.force[i].y() / node.mass();
    energy += 0.5 * (node.solid * v.solid.squaredNorm() + node.fluid * water.squaredNorm());
    if (!scheme_.held(i))
      energy -= 0.125 * dt * dt * (node.solid * a_solid.squaredNorm() + node.fluid * a_fluid.squaredNorm());
  }
  for (std::size_t e = 0; e < state_.stress.size(); ++e) {
    const ElementStress& stress = state_.stress[e];
    const Vector2d mean = 0.5 * (now.velocity[e].solid + now.velocity[e + 1].solid);
    const auto flux = [&](std::size_t i) {
      return state_.grid.nodes[i].porosity() * now.velocity[i].relative.x();
    };
    double power = (stress.xx - stress.pressure) * mean.x() + stress.xy * mean.y();
    if (state_.grid.elements[e].flows())
      power -= stress.pressure * 0.5 * (flux(e) + flux(e + 1));
    energy += settings_.slowness_x * state_.grid.elements[e].length * power;
  }
  return energy;
}

WetEnergy MarchedColumn::energy() const {
  WetEnergy energy = spent_;
  energy.kinetic = kinetic_energy();
  for (std::size_t e = 0; e < state_.stress.size(); ++e)
    energy.plastic +=
        state_.grid.elements[e].length * state_.soil.plastic_work[e] / state_.relaxation.seen(e).shear;
  energy.elastic -= energy.plastic;
  return energy;
}

} // namespace tremolo::freefield
