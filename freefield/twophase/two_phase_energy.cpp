// Work of the two-phase column. With v- and v+ the velocities half a step before and after t, v = (v- + v+)/2
// and F, F~ the forces on a node (node_kick.hpp), both phases gain
//
//     m_s v_s.a_s + m_f v_f.a_f = F.v_s + n_I (F~ - d w+).w,
//
// n_I = m_f/m~_f; drag is implicit and takes w+. An element's stress and pressure give -sigma'.d eps/dt and
// p d(v_s + n w)/dy of F and F~; they are booked by the trapezoidal rule on the strain of the step, as is the
// power of base, load, drag and dashpots in time. A law that sees a share of the strain has counted that
// share of the plastic work. The work of relaxation mechanisms is booked as damping; what they still hold of
// it they give back within seconds.

#include "freefield/twophase/two_phase_column.hpp"

namespace tremolo::freefield {

/// Books the step of an element from its stress before to that after, damping included.
void TwoPhaseColumn::count_strain(std::size_t e, double shear, double vertical) {
  const double at_rest = state_.syy[e] - soil_.vertical(state_, e);
  const double half = 0.5 * grid_.elements[e].length;
  const double soil =
      half * ((sxy_before_[e] + state_.sxy[e]) * dgxy_[e] + (syy_before_[e] + state_.syy[e]) * deyy_[e]);
  const double gravity = 2.0 * half * at_rest * deyy_[e];
  spent_.elastic += soil;
  spent_.gravity += gravity;
  spent_.damping +=
      half * ((shear_[e] + shear) * dgxy_[e] + (vertical_[e] + vertical) * deyy_[e]) - (soil - gravity);
}

/// Traction below the base node, in x (0) or y (1), Pa: that of the half-space, or the traction that moves a
/// rigid base.
double TwoPhaseColumn::base_traction(std::size_t c) const {
  const WetNode& node = grid_.nodes.front();
  const Phases& before = before_.front()[c];
  const Phases& after = v_.front()[c];
  const auto momentum = [&](const Phases& v) { return node.solid * v.solid + node.fluid * v.fluid; };
  if (settings_.base == BaseKind::rigid)
    return (momentum(after) - momentum(before)) / settings_.time_step - base_force_[c];
  const double mean = 0.5 * (momentum(before) + momentum(after)) / node.mass();
  const Velocity incident = input_(time());
  return c == 0 ? grid_.impedance_x * (2.0 * incident.x - mean)
                : grid_.impedance_y * (2.0 * incident.y - mean);
}

TwoPhaseColumn::Power TwoPhaseColumn::power() const {
  Power power;
  const std::size_t last = v_.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const WetNode& node = grid_.nodes[i];
    const bool held = i == 0 && settings_.base == BaseKind::rigid;
    for (const std::size_t c : {std::size_t{0}, std::size_t{1}}) {
      const Phases& after = v_[i][c];
      const double solid = 0.5 * (before_[i][c].solid + after.solid);
      const double w = 0.5 * (before_[i][c].fluid + after.fluid) - solid;
      power.drag += node.porosity() * node.drag * (after.fluid - after.solid) * w;
      if (!held) {
        const double reference = c == 0 ? reference_.x : reference_.y;
        const double drag = node.mass_damping * (solid + node.fluid / node.mass() * w - reference);
        power.damping += drag * (solid - reference);
        power.base -= drag * reference;
      }
      if (i == 0)
        power.base += base_traction(c) * solid;
      if (i == 0 && c == 1 && settings_.base_pressure)
        power.base += settings_.base_pressure(time()) * node.porosity() * w;
      if (i == last && c == 1 && settings_.surface_load)
        power.load += settings_.surface_load(time()) * solid;
    }
  }
  return power;
}

/// Books the step that has just been made.
void TwoPhaseColumn::count_power() {
  const Power now = power();
  const double half = 0.5 * settings_.time_step;
  spent_.base += half * (power_.base + now.base);
  spent_.load += half * (power_.load + now.load);
  spent_.drag += half * (power_.drag + now.drag);
  spent_.damping += half * (power_.damping + now.damping);
  power_ = now;
}

WetEnergy TwoPhaseColumn::energy() const {
  WetEnergy energy = spent_;
  for (std::size_t i = 0; i < v_.size(); ++i)
    for (const std::size_t c : {std::size_t{0}, std::size_t{1}}) {
      const double solid = 0.5 * (before_[i][c].solid + v_[i][c].solid);
      const double fluid = 0.5 * (before_[i][c].fluid + v_[i][c].fluid);
      energy.kinetic += 0.5 * (grid_.nodes[i].solid * solid * solid + grid_.nodes[i].fluid * fluid * fluid);
    }
  for (std::size_t e = 0; e < lengths_.size(); ++e)
    energy.plastic += grid_.elements[e].length * state_.plastic_work[e] / relaxation_.seen(e).shear;
  energy.elastic -= energy.plastic;
  return energy;
}

} // namespace tremolo::freefield
