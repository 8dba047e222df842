// Fields that depend on t - s x have d/dx = -s d/dt. Zienkiewicz & Shiomi's equations in the form of two
// velocities (two_phase_column.cpp), excess over the state at rest, S = sigma' - p, q = n w:
//
//     d/dt [rho vx + rho_f qx + s Sxx] = d sxy/dy
//     d/dt [rho vy + rho_f qy + s sxy] = d Syy/dy
//     d/dt [rho_f (vx + qx/n) - s p]   = -(rho_f g/k) qx
//     d/dt [rho_f (vy + qy/n)]         = -dp/dy - (rho_f g/k) qy
//
//     d exx = -s dvx,   d eyy = d(vy)/dy dt,   d gxy = d(vx)/dy dt - s dvy
//     d sigma' = law(d exx, d eyy, d gxy),     dp = -(K_f/n) [d(vy + qy)/dy dt - s d(vx + qx)]
//
// Brackets at nodes (marched_node.hpp), stress at centres. From t to t + dt, the momenta P, R at t + dt/2
// known and X the increments of stress:
//
//     velocities at t + dt/2 from P, R and stress + X/2,   R' = R - dt d w,
//     velocities at t + dt   from P, R' and stress + X,    strain (element_strain.hpp),   X = law(strain);
//     then   P += dt F(stress),  R = R' + dt F~(p).
//
// At s = 0 the first line does not need X and this is the two-phase column. Constant damping adds the stress
// of relaxation mechanisms to that of the law (column_relaxation.hpp), in X. Other small-strain damping is a
// viscous stress beta (G dvx/dy, M dvy/dy) in F alone: in proportion to the whole strain rate it would make
// the problem ill posed, since waves of high frequency would be post-critical.

#include "freefield/marched/marched_trial.hpp"

#include <algorithm>
#include <utility>

namespace tremolo::freefield {

using Eigen::ArrayXd;
using Eigen::Vector2d;

namespace {

auto x_y(auto& fields) {
  return fields.template leftCols<2>();
}
auto w_xy(auto& fields) {
  return fields.template rightCols<2>();
}

/// The values at the upper node of each element, and at the lower one.
auto upper(auto&& nodes) {
  return nodes.bottomRows(nodes.rows() - 1);
}
auto lower(auto&& nodes) {
  return nodes.topRows(nodes.rows() - 1);
}

void set_row(NodeFields& fields, Eigen::Index i, const Vector2d& left, const Vector2d& right) {
  fields(i, 0) = left.x();
  fields(i, 1) = left.y();
  fields(i, 2) = right.x();
  fields(i, 3) = right.y();
}

Eigen::Map<const ArrayXd> array(const std::vector<double>& values) {
  return {values.data(), std::ssize(values)};
}

} // namespace

MarchedTrial::MarchedTrial(const ColumnSoil& soil, const MarchedState& state)
    : soil_(&soil), soil_state_(state.soil) {
  const Eigen::Index nodes = std::ssize(state.velocity), elements = std::ssize(state.stress);
  for (NodeFields* fields :
       {&half_given_, &whole_given_, &velocity_, &momenta_, &half_, &whole_, &lateral_, &force_})
    fields->setZero(nodes, 4);
  for (ElementFields* fields : {&before_, &stress_, &strain_, &followed_, &owed_})
    fields->setZero(elements, 4);
  for (PlaneFields* fields : {&kept_, &faded_, &law_before_, &law_stress_, &scratch_})
    fields->setZero(elements, 3);
  for (PlaneFactors* factors : {&of_law_, &of_step_, &seen_, &taken_})
    factors->resize(elements);
  relaxes_ = state.relaxation.acts();
  for (Eigen::Index e = 0; e < elements; ++e) {
    seen_.set(e, state.relaxation.seen(static_cast<std::size_t>(e)));
    taken_.set(e, state.relaxation.taken(static_cast<std::size_t>(e)));
  }
  drag_.setZero(nodes, 2);
  viscosity_.setZero(elements, 2);
  viscous_.setZero(elements, 2);
  mean_.setZero(nodes, 2);
  porosity_.setZero(nodes);
  for (ArrayXd* values : {&share_, &flowing_, &per_length_, &water_stiff_, &lowest_, &excess_})
    values->setZero(elements);
  for (std::vector<double>* strain : {&dexx_, &deyy_, &dgxy_})
    strain->resize(state.stress.size());
}

void MarchedTrial::begin(const MarchedScheme& scheme, const MarchedState& state, const BaseDrive& drive,
                         const std::vector<double>& moduli, const std::vector<double>& degraded) {
  drive_ = drive;
  base_brake_ = scheme.braked(state.grid.nodes.front());
  damped_ = !degraded.empty();
  for (Eigen::Index e = 0; e < share_.size(); ++e) {
    const auto k = static_cast<std::size_t>(e);
    const WetElement& element = state.grid.elements[k];
    const double m = moduli[k];
    share_[e] = 0.5 * scheme.slowness * element.length;
    flowing_[e] = element.flows() ? 1.0 : 0.0;
    per_length_[e] = scheme.dt / element.length;
    set_stiffness(e, state, m);
    water_stiff_[e] = element.stiffness;
    lowest_[e] = element.stiffness > 0.0 ? element.lowest_excess : 0.0;
    if (damped_) {
      const double viscosity = element.beta * degraded[k] / element.length;
      viscosity_.row(e) << element.shear_ratio * viscosity, viscosity;
    }
    const ElementStress& stress = state.stress[k];
    before_.row(e) << stress.xx, stress.yy, stress.xy, stress.pressure;
    if (relaxes_) {
      const InPlane kept = state.relaxation.kept(k), held = state.relaxation.stress(k);
      kept_.row(e) << kept.xx, kept.yy, kept.xy;
      faded_.row(e) << kept.xx - held.xx, kept.yy - held.yy, kept.xy - held.xy;
    }
  }
  law_before_ = state.law_stress;
  find_loads(before_);
  for (Eigen::Index i = 0; i < porosity_.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const WetNode& node = state.grid.nodes[k];
    set_row(half_given_, i, state.momenta[k].mixture, state.momenta[k].fluid);
    set_row(velocity_, i, state.velocity[k].solid, state.velocity[k].relative);
    porosity_[i] = node.porosity();
  }
  masses_.gather(state.grid.nodes);
  scheme.set_half(half_split_, masses_);
  scheme.set_whole(whole_split_, masses_);
  drag_.col(0) = drag_.col(1) = scheme.dt * masses_.drag;
  add_driving_force();
  half_given_ -= lateral_;
  whole_given_ = half_given_ + 0.5 * scheme.dt * force_;
}

void MarchedTrial::set_stiffness(Eigen::Index e, const MarchedState& state, double modulus) {
  const auto k = static_cast<std::size_t>(e);
  const WetElement& element = state.grid.elements[k];
  const double shear = element.shear_ratio * modulus, area = element.lateral_ratio * modulus + shear;
  of_law_.set(e, state.relaxation.seen(k), area, shear);
  of_step_.set(e, state.relaxation.over_a_step(k), area, shear);
}

/// Finds the loads of the elements' stress on the nodes: s N, F and F~, in the order of G and R.
void MarchedTrial::find_loads(const ElementFields& stress) {
  const auto xx = stress.col(0), yy = stress.col(1), xy = stress.col(2), pressure = stress.col(3);
  const auto add = [](NodeFields& fields, Eigen::Index c, double side, const auto& values) {
    fields.col(c).setZero();
    lower(fields.col(c)) = values;
    upper(fields.col(c)) += side * values;
  };
  add(lateral_, 0, 1.0, share_ * (xx - pressure));
  add(lateral_, 1, 1.0, share_ * xy);
  add(lateral_, 2, 1.0, -share_ * flowing_ * pressure);
  add(force_, 0, -1.0, xy);
  add(force_, 1, -1.0, yy - pressure);
  add(force_, 3, -1.0, -flowing_ * pressure);
}

void MarchedTrial::move(const MarchedScheme& scheme, const Increments& increment) {
  const double tau = 0.5 * scheme.dt;
  find_loads(increment);
  momenta_ = half_given_ - 0.5 * lateral_;
  if (scheme.held(0))
    momenta_.row(0).head<2>() = drive_.half.transpose();
  half_split_(momenta_, half_);

  momenta_ = whole_given_ + tau * force_ - lateral_;
  w_xy(momenta_) -= drag_ * w_xy(half_);
  if (damped_) {
    viscous_ = viscosity_ * (upper(x_y(half_)) - lower(x_y(half_)));
    lower(x_y(momenta_)) += tau * viscous_;
    upper(x_y(momenta_)) -= tau * viscous_;
  }
  const Vector2d base = momenta_.row(0).head<2>().transpose();
  momenta_.row(0).head<2>() = scheme.at_base(base, base_brake_, drive_.whole).transpose();
  whole_split_(momenta_, whole_);
  find_strain(scheme);
}

/// Finds the strain by element_strain.hpp.
void MarchedTrial::find_strain(const MarchedScheme& scheme) {
  const double m = 0.5 * scheme.slowness;
  const auto slope = [&](const auto& values) { return per_length_ * (upper(values) - lower(values)); };
  const auto moved = [&](Eigen::Index c) { return whole_.col(c) - velocity_.col(c); };
  strain_.col(0) = -m * (upper(moved(0)) + lower(moved(0)));
  strain_.col(1) = slope(half_.col(1));
  strain_.col(2) = slope(half_.col(0)) - m * (upper(moved(1)) + lower(moved(1)));
  strain_.col(3) = strain_.col(0) + strain_.col(1);
  const ArrayXd qy = porosity_ * half_.col(3), dqx = porosity_ * moved(2);
  strain_.col(3) += flowing_ * (slope(qy) - m * (upper(dqx) + lower(dqx)));
}

void MarchedTrial::elastic_increment(Increments& made) const {
  of_step_.apply(strain_, made.leftCols<3>());
  if (relaxes_)
    made.leftCols<3>() += faded_;
  made.col(3) = -water_stiff_ * strain_.col(3);
}

void MarchedTrial::evaluate(const MarchedScheme& scheme, const MarchedState& state,
                            const Increments& increment, Increments& residual) {
  move(scheme, increment);
  followed_ = strain_ + state.owed;
  owed_.setZero();
  if (relaxes_)
    seen_.apply(followed_, scratch_);
  else
    scratch_ = followed_.leftCols<3>();
  const auto pass_on = [&](Eigen::Index c, std::vector<double>& strain) {
    ArrayXd::Map(strain.data(), std::ssize(strain)) = scratch_.col(c);
  };
  pass_on(0, dexx_);
  pass_on(1, deyy_);
  pass_on(2, dgxy_);
  soil_state_ = state.soil;
  soil_->update(soil_state_, dexx_, deyy_, dgxy_);
  find_stress(state);
  residual = stress_ - before_ - increment;
}

void MarchedTrial::settle(const MarchedScheme& scheme, const MarchedState& state,
                          const Increments& increment) {
  move(scheme, increment);
  owed_ = strain_ + state.owed - followed_;
  find_stress(state);
}

/// The stress of the elements by their laws, with what they are owed as elastic, and by relaxation
/// mechanisms.
void MarchedTrial::find_stress(const MarchedState& state) {
  const SoilState& rest = soil_->initial();
  of_law_.apply(owed_, law_stress_);
  law_stress_.col(0) += array(soil_state_.sxx) - array(rest.sxx);
  law_stress_.col(1) += array(soil_state_.syy) - array(rest.syy);
  law_stress_.col(2) += array(soil_state_.sxy);
  if (relaxes_) {
    taken_.apply(law_stress_ - law_before_, scratch_);
    stress_.leftCols<3>() = law_stress_ + kept_ + scratch_;
  } else {
    stress_.leftCols<3>() = law_stress_;
  }
  excess_ = array(state.excess) - water_stiff_ * strain_.col(3);
  stress_.col(3) = excess_.max(lowest_);
}

/// Adds the forces of dashpots and incident wave to the nodes.
void MarchedTrial::add_driving_force() {
  force_.col(0) += drive_.reference.x() * masses_.mass_damping;
  force_.col(1) += drive_.reference.y() * masses_.mass_damping;
  force_.row(0).head<2>() += drive_.traction.transpose().array();
}

void MarchedTrial::finish(const MarchedScheme& scheme) {
  find_loads(stress_);
  lower(x_y(force_)) += viscous_;
  upper(x_y(force_)) -= viscous_;
  internal_force_ = force_.row(0).head<2>().transpose();
  add_driving_force();
  mean_ = x_y(whole_) + (masses_.fluid / masses_.mass).replicate<1, 2>() * w_xy(whole_);
  x_y(force_) -= masses_.mass_damping.replicate<1, 2>() * mean_;
  const Vector2d base = mean_.row(0).transpose();
  force_.row(0).head<2>() -= (scheme.half_space * base).transpose().array();
}

Vector2d MarchedTrial::base_bracket() const {
  return (masses_.mass[0] * mean_.row(0) + lateral_.row(0).head<2>()).transpose();
}

void MarchedTrial::accept(const MarchedScheme& scheme, MarchedState& state) {
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    NodeMomenta& momenta = state.momenta[i];
    momenta.mixture += scheme.dt * force(i);
    momenta.fluid -= (drag_.row(k) * w_xy(half_).row(k)).matrix().transpose();
    momenta.fluid.y() += scheme.dt * fluid_force(i);
    state.velocity[i] = whole(i);
  }
  for (std::size_t e = 0; e < state.stress.size(); ++e)
    state.stress[e] = stress(e);
  Eigen::ArrayXd::Map(state.excess.data(), std::ssize(state.excess)) = excess_;
  state.owed = owed_;
  for (std::size_t e = 0; relaxes_ && e < state.stress.size(); ++e) {
    const auto k = static_cast<Eigen::Index>(e);
    const Eigen::Array3d change = (law_stress_.row(k) - law_before_.row(k)).transpose();
    state.relaxation.advance(e, {change[0], change[1], change[2]});
  }
  state.law_stress = law_stress_;
  std::swap(state.soil, soil_state_);
}

} // namespace tremolo::freefield
