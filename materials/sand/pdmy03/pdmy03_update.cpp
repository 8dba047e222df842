// One step of one point: elastic trial, reversal, and where the trial leaves the elastic core, parts of about
// 1e-5 strain. Each part is corrected along the normal at the contact point, where the line from the axis of
// the active surface to the trial stress meets it, and may cross several surfaces:
//
//     L = Q:(sigma_trial - sigma_contact)/A,    A = 2 G Q':Q' + 9 B Q'' P'' + H',
//     s <- s_trial - 2 G L Q',    sigma_m <- sigma_m,trial - 3 B P'' L.
//
// Effective stress is never tensile; expansion beyond zero is remembered as a gap that must close first.

#include "materials/law/finite_input.hpp"
#include "materials/law/strain_limit.hpp"
#include "materials/sand/pdmy03/pdmy03_cone.hpp"
#include "materials/sand/pdmy03/pdmy03_flow.hpp"
#include "materials/sand/pdmy03/pdmy03_state.hpp"
#include "materials/sand/pdmy03/pdmy03_stiffness.hpp"
#include "materials/tensor/material_axes.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {
namespace {

using Place = pdmy03_state::Place;

/// Mean effective stress (Pa, never positive) and gap.
struct MeanStress {
  double stress = 0.0;
  double gap = 0.0;
};

/// Elastic change of the mean stress by a volumetric strain: a gap closes first, and opens instead of
/// tension.
MeanStress strained(const MeanStress& from, double bulk, double volume) {
  if (from.gap > 0.0) {
    const double left = from.gap + volume;
    return left >= 0.0 ? MeanStress{0.0, left} : MeanStress{std::min(0.0, from.stress + bulk * left), 0.0};
  }
  const double stress = from.stress + bulk * volume;
  return stress > 0.0 ? MeanStress{0.0, stress / bulk} : MeanStress{stress, 0.0};
}

/// Shear and bulk modulus at a pressure, and their factor F.
struct Stiffness {
  double factor = 1.0;
  double shear = 0.0;
  double bulk = 0.0;
};

/// One point on its way through one step.
class Step {
public:
  Step(const Pdmy03& law, double* block, const MeanAndDeviator& stress)
      : law_(law), memory_(block), active_(static_cast<std::size_t>(memory_[Place::active_surface])),
        s_(stress.deviator), mean_{std::min(0.0, stress.mean), memory_[Place::gap]} {}

  /// Takes the strain increment.
  /// @return plastic work, J/m3
  double take(double volume, const Deviator3& increment);

  MeanAndDeviator stress() const { return {mean_.stress, s_}; }

private:
  double height(double mean) const { return law_.residual_pressure - mean; }

  Stiffness stiffness(double height) const {
    const double factor = pdmy03_modulus_factor(law_, height);
    return {factor, factor * 0.5 * law_.tangent_modulus[0], factor * law_.elastic.bulk_modulus()};
  }

  YieldCone surface(std::size_t i) const { return {law_.ratio[i], memory_.resting_centre(i, law_.surfaces)}; }
  /// Whether a stress is elastic when no surface is active. The slack is what rounding to float moves
  /// surfaces by; without it a point at rest on several surfaces would creep under increments of no account.
  bool in_core(const Deviator3& s, double height) const {
    constexpr double slack = 5e-6;
    const double radius = law_.ratio[1] * height;
    return surface(1).yield_function(s, height) <= slack * radius * radius;
  }
  void activate(std::size_t i) {
    active_ = i;
    cone_ = surface(i);
  }

  IncrementStart begin(const Deviator3& increment) const;
  void reverse_if_unloading(const MeanStress& trial, const Deviator3& trial_deviator);
  int parts(double factor, double volume, const Deviator3& increment) const;
  double part(const IncrementStart& start, double volume, const Deviator3& increment);
  void correct(const IncrementStart& start, const Stiffness& moduli, FlowStress flow,
               const FlowStrain& strain, MeanStress trial);
  double consistency(double& flow, const Stiffness& moduli, const MeanAndDeviator& normal) const;

  const Pdmy03& law_;
  Pdmy03Memory memory_;
  std::size_t active_;
  YieldCone cone_; ///< the active surface
  Deviator3 s_;
  MeanStress mean_;
  Deviator3 committed_deviator_ = s_; ///< at the start of the step
  double committed_height_ = height(mean_.stress);
};

IncrementStart Step::begin(const Deviator3& increment) const {
  IncrementStart start;
  start.increment = increment;
  const double largest = memory_[Place::largest_pressure];
  const double relative = (largest + mean_.stress) / (largest + law_.residual_pressure);
  start.damage = relative > 0.0 ? std::sqrt(std::sqrt(relative)) : 0.0;
  start.cyclic_factor = cyclic_factor(law_, std::abs(s_.xy()) / memory_[Place::initial_height],
                                      memory_[Place::initial_shear_ratio]);
  start.turned = dot(increment, memory_.deviator(Place::pivot_direction)) < 0.0;
  return start;
}

/// Unloading from the active surface: all smaller ones come to touch it where the stress of the last step is.
void Step::reverse_if_unloading(const MeanStress& trial, const Deviator3& trial_deviator) {
  if (active_ == 0)
    return;
  const MeanAndDeviator normal = cone_.normal(s_, height(mean_.stress));
  const double mean_change = height(trial.stress) - committed_height_; // of p'
  const Deviator3 change = trial_deviator - committed_deviator_;
  const double outward = dot(normal.deviator, change) - 3.0 * normal.mean * mean_change;
  const double rounding = 1e-12 * (norm(change) + std::abs(mean_change));
  if (outward >= -rounding) // along the surface is not unloading
    return;
  for (std::size_t j = 1; j < active_; ++j)
    memory_.rest_centre(j, cone_.centre_inside(committed_deviator_, committed_height_, law_.ratio[j]));
  if (active_ < law_.surfaces)
    memory_.rest_centre(active_, cone_.centre);
  active_ = 0;
}

int Step::parts(double factor, double volume, const Deviator3& increment) const {
  constexpr double largest_part = 1e-5;
  const double strain = norm(increment);
  const double stress = factor * law_.tangent_modulus[active_] * strain / std::sqrt(3.0);
  const double n = static_cast<double>(law_.surfaces);
  const double step = std::sqrt(2.0) * law_.ratio[law_.surfaces] * height(mean_.stress) / n;
  const double crossings = std::min(1.0 + 3.0 * stress / step, n);
  const double by_shear = octahedral_strain(increment) / largest_part;
  const double by_volume = std::abs(volume) / 3.0 / largest_part;
  return std::max(1, static_cast<int>(std::max({crossings, by_shear, by_volume})));
}

double Step::take(double volume, const Deviator3& increment) {
  if (active_ > 0)
    cone_ = {law_.ratio[active_], memory_.deviator(Place::active_centre)};
  const Stiffness moduli = stiffness(committed_height_);
  const MeanStress trial = strained(mean_, moduli.bulk, volume);
  const Deviator3 trial_deviator = s_ + 2.0 * moduli.shear * increment;
  reverse_if_unloading(trial, trial_deviator);
  double work = 0.0;
  if (active_ == 0 && in_core(trial_deviator, height(trial.stress))) {
    s_ = trial_deviator;
    mean_ = trial;
    memory_[Place::volume_strain] += volume;
    memory_.set(Place::strain, memory_.deviator(Place::strain) + increment);
  } else {
    const IncrementStart start = begin(increment);
    const int count = parts(moduli.factor, volume, increment);
    const double share = 1.0 / count;
    for (int k = 0; k < count; ++k)
      work += part(start, share * volume, share * increment);
  }
  memory_[Place::active_surface] = static_cast<double>(active_);
  if (active_ > 0)
    memory_.set(Place::active_centre, cone_.centre);
  memory_[Place::gap] = mean_.gap;
  memory_[Place::largest_pressure] = std::max(memory_[Place::largest_pressure], -mean_.stress);
  return work;
}

double Step::part(const IncrementStart& start, double volume, const Deviator3& increment) {
  const Stiffness moduli = stiffness(height(mean_.stress));
  const MeanStress trial = strained(mean_, moduli.bulk, volume);
  const Deviator3 trial_deviator = s_ + 2.0 * moduli.shear * increment;
  FlowStress flow;
  flow.start_volume = memory_[Place::volume_strain];
  flow.volume = memory_[Place::volume_strain] += volume;
  const FlowStrain strain = {memory_.deviator(Place::strain) + increment, octahedral_strain(increment)};
  memory_.set(Place::strain, strain.end);

  reverse_if_unloading(trial, trial_deviator);
  if (active_ == 0) {
    if (in_core(trial_deviator, height(trial.stress))) {
      s_ = trial_deviator;
      mean_ = trial;
      return 0.0;
    }
    activate(1);
  }
  const Deviator3 first = s_;
  const double first_mean = mean_.stress;
  flow.start = s_;
  flow.start_height = height(mean_.stress);
  flow.trial = trial_deviator;
  correct(start, moduli, flow, strain, trial);
  return 0.5 * dot(first + s_, trial_deviator - s_) / (2.0 * moduli.shear) +
         0.5 * (first_mean + mean_.stress) * (trial.stress - mean_.stress) / moduli.bulk;
}

/// A, with the flow changed where it would make A smaller than half the plastic modulus.
double Step::consistency(double& flow, const Stiffness& moduli, const MeanAndDeviator& normal) const {
  const double plastic = moduli.factor * law_.plastic_modulus[active_];
  const double least = 0.5 * moduli.factor * law_.plastic_modulus[std::min(active_, law_.surfaces - 1)];
  const double shear = 2.0 * moduli.shear * dot(normal.deviator, normal.deviator);
  const double volumetric = 9.0 * moduli.bulk * normal.mean;
  const double a = shear + volumetric * flow + plastic;
  if (a >= least)
    return a;
  flow = (least - shear - plastic) / volumetric; // not 0: a is below shear + plastic
  return least;
}

void Step::correct(const IncrementStart& start, const Stiffness& moduli, FlowStress flow,
                   const FlowStrain& strain, MeanStress trial) {
  for (bool crossed = false;; crossed = true) {
    flow.height = height(trial.stress);
    flow.contact = cone_.projected(flow.trial, flow.height);
    const MeanAndDeviator normal = cone_.normal(flow.contact, flow.height);
    double volumetric = volumetric_flow(law_, memory_, start, flow, strain);
    const double a = consistency(volumetric, moduli, normal);
    double multiplier = std::max(0.0, dot(normal.deviator, flow.trial - flow.contact)) / a;
    if (crossed) { // what lies beyond has been corrected with the modulus of the surface before
      const double before = law_.plastic_modulus[active_ - 1];
      multiplier *= (before - law_.plastic_modulus[active_]) / before;
    }
    double deviatoric = 1.0;
    const double plastic_volume = 3.0 * volumetric * multiplier;
    const double closed = std::clamp(plastic_volume, 0.0, trial.gap);
    mean_ = {trial.stress - moduli.bulk * (plastic_volume - closed), trial.gap - closed};
    if (mean_.stress > 0.0) { // flow stops at zero effective stress
      deviatoric = trial.stress / (trial.stress - mean_.stress);
      mean_.stress = 0.0;
    }
    s_ = flow.trial - (2.0 * moduli.shear * multiplier * deviatoric) * normal.deviator;
    const double now = height(mean_.stress);
    if (active_ == law_.surfaces || cone_.yield_function(s_, now) < 0.0)
      s_ = cone_.projected(s_, now);
    if (active_ == law_.surfaces)
      return;
    const YieldCone next = surface(active_ + 1);
    if (next.yield_function(s_, now) <= 0.0) {
      cone_.centre = translated_centre(cone_, next, s_, now);
      return;
    }
    activate(active_ + 1);
    flow.trial = s_;
    trial = mean_;
  }
}

} // namespace

void update(const Pdmy03& law, const Points& points) {
  check_increments("pdmy03", points, pdmy03_largest_increment);
  const std::size_t size = pdmy03_state_size(law.surfaces);
  check_finite("pdmy03", points, size);
  for (std::size_t i = 0; i < points.count; ++i) {
    double* block = points.state + i * size;
    block[Place::rotation] = MaterialAxes::turned(block[Place::rotation], points.dwxy[i]);
    const MaterialAxes axes(block[Place::rotation]);
    const InPlaneStress plane =
        axes.to_material(rotated({points.sxx[i], points.syy[i], points.sxy[i]}, points.dwxy[i]));
    const InPlaneStress strain = axes.to_material({points.dexx[i], points.deyy[i], 0.5 * points.dgxy[i]});
    const double out_of_plane = points.dezz == nullptr ? 0.0 : points.dezz[i];

    const MeanAndDeviator increment = split(strain.xx, strain.yy, out_of_plane, strain.xy);
    Step step(law, block, split(plane.xx, plane.yy, points.szz[i], plane.xy));
    points.plastic_work[i] += step.take(3.0 * increment.mean, increment.deviator);

    const TensorComponents end = components(step.stress());
    const InPlaneStress stress = axes.to_space({end.xx, end.yy, end.xy});
    points.sxx[i] = stress.xx;
    points.syy[i] = stress.yy;
    points.szz[i] = end.zz;
    points.sxy[i] = stress.xy;
  }
}

} // namespace tremolo::materials
