// One step of four points: elastic trial, reversal, and where the trial leaves the elastic core, parts of
// about 1e-5 strain. Each part is corrected along the normal at the contact point, where the line from the
// axis of the active surface to the trial stress meets it, and may cross several surfaces:
//
//     L = Q:(sigma_trial - sigma_contact)/A,    A = 2 G Q':Q' + 9 B Q'' P'' + H',
//     s <- s_trial - 2 G L Q',    sigma_m <- sigma_m,trial - 3 B P'' L.
//
// Effective stress is never tensile; expansion beyond zero is remembered as a gap that must close first.
// Points have parts of their own; those that have none left, or have crossed no further surface, wait for the
// others.

#include "materials/law/finite_input.hpp"
#include "materials/law/four_points.hpp"
#include "materials/law/strain_limit.hpp"
#include "materials/sand/pdmy03/pdmy03_active.hpp"
#include "materials/sand/pdmy03/pdmy03_flow.hpp"
#include "materials/sand/pdmy03/pdmy03_stiffness.hpp"

#include <cmath>

namespace tremolo::materials {
namespace {

using MeanAndDeviators = MeanAndDeviatorOf<Lanes>;

/// Mean effective stress (Pa, never positive) and gap.
struct MeanStress {
  Lanes stress;
  Lanes gap;
};

MeanStress choose(const LaneMask& mask, const MeanStress& a, const MeanStress& b) {
  return {tremolo::choose(mask, a.stress, b.stress), tremolo::choose(mask, a.gap, b.gap)};
}
using tremolo::materials::choose;

/// Elastic change of the mean stress by a volumetric strain: a gap closes first, and opens instead of
/// tension.
MeanStress strained(const MeanStress& from, const Lanes& bulk, const Lanes& volume) {
  const Lanes stress = from.stress + bulk * volume;
  const LaneMask apart = from.gap > 0.0;
  const LaneMask opens = ~apart & (stress > 0.0);
  if (!any(apart | opens))
    return {stress, from.gap};
  const Lanes left = from.gap + volume;
  const MeanStress together = {smaller(stress, Lanes{}), choose(opens, stress / bulk, Lanes{})};
  const MeanStress closed = {smaller(from.stress + bulk * left, Lanes{}), Lanes{}};
  return choose(apart, choose(left >= 0.0, MeanStress{Lanes{}, left}, closed), together);
}

/// Shear and bulk modulus at a pressure, and their factor F.
struct Stiffness {
  Lanes factor;
  Lanes shear;
  Lanes bulk;
};

/// Four points on their way through one step.
class Step {
public:
  /// @param present  the points to take; the others are of no meaning
  Step(const Pdmy03& law, Pdmy03States& state, const RestingCentresOfFour& resting,
       const MeanAndDeviators& stress, const LaneMask& present)
      : law_(law), state_(state), present_(present),
        active_(law, resting, state.active_surface, state.active_centre, present),
        s_(stress.deviator), mean_{smaller(stress.mean, Lanes{}), state.gap} {}

  /// Takes the strain increments.
  /// @return plastic work, J/m3
  Lanes take(const Lanes& volume, const Deviators3& increment);

  MeanAndDeviators stress() const { return {mean_.stress, s_}; }

private:
  Lanes height(const Lanes& mean) const { return law_.residual_pressure - mean; }

  Stiffness stiffness(const Lanes& height) const {
    const Lanes factor = pdmy03_modulus_factor(law_, height);
    return {factor, factor * 0.5 * law_.tangent_modulus[0], factor * law_.elastic.bulk_modulus()};
  }

  LaneMask in_core(const Deviators3& s, const Lanes& height) const;
  IncrementStart begin(const Deviators3& increment) const;
  void reverse_if_unloading(const LaneMask& which, const MeanStress& trial, const Deviators3& trial_deviator);
  Lanes parts(const Lanes& factor, const Lanes& volume, const Deviators3& increment) const;
  Lanes part(const LaneMask& which, const IncrementStart& start, const Lanes& volume,
             const Deviators3& increment);
  void correct(LaneMask which, const IncrementStart& start, const Stiffness& moduli, FlowStress flow,
               const FlowStrain& strain, MeanStress trial);
  Lanes consistency(Lanes& flow, const Stiffness& moduli, const MeanAndDeviators& normal) const;

  const Pdmy03& law_;
  Pdmy03States& state_;
  LaneMask present_;
  ActiveSurfaces active_;
  Deviators3 s_;
  MeanStress mean_;
  Deviators3 committed_deviator_ = s_; ///< at the start of the step
  Lanes committed_height_ = height(mean_.stress);
};

/// Whether a stress is elastic when no surface is active. The slack is what rounding to float moves surfaces
/// by; without it a point at rest on several surfaces would creep under increments of no account.
LaneMask Step::in_core(const Deviators3& s, const Lanes& height) const {
  constexpr double slack = 5e-6;
  const LaneMask free = active_.inside_all();
  if (!any(free))
    return free;
  const Lanes radius = law_.ratio[1] * height;
  return free & (active_.core().yield_function(s, height) <= slack * radius * radius);
}

IncrementStart Step::begin(const Deviators3& increment) const {
  IncrementStart start;
  start.increment = increment;
  const Lanes largest = state_.largest_pressure;
  start.damage = sqrt(sqrt(positive((largest + mean_.stress) / (largest + law_.residual_pressure))));
  start.cyclic_factor =
      cyclic_factor(law_, magnitude(s_.xy()) / state_.initial_height, state_.initial_shear_ratio);
  start.turned = dot(increment, state_.pivot_direction) < 0.0;
  return start;
}

/// Unloading from the active surface: all smaller ones come to touch it where the stress of the last step is.
void Step::reverse_if_unloading(const LaneMask& which, const MeanStress& trial,
                                const Deviators3& trial_deviator) {
  const LaneMask loaded = which & ~active_.inside_all();
  if (!any(loaded))
    return;
  const MeanAndDeviators normal = active_.cone().normal(s_, height(mean_.stress));
  const Lanes mean_change = height(trial.stress) - committed_height_; // of p'
  const Deviators3 change = trial_deviator - committed_deviator_;
  const Lanes outward = dot(normal.deviator, change) - 3.0 * normal.mean * mean_change;
  const Lanes rounding = 1e-12 * (norm(change) + magnitude(mean_change));
  const LaneMask unloads = loaded & (outward < -rounding); // along the surface is not unloading
  if (any(unloads))
    active_.leave(unloads, committed_deviator_, committed_height_);
}

Lanes Step::parts(const Lanes& factor, const Lanes& volume, const Deviators3& increment) const {
  constexpr double largest_part = 1e-5;
  const Lanes stress = factor * active_.tangent_modulus() * norm(increment) / std::sqrt(3.0);
  const double n = static_cast<double>(law_.surfaces);
  const Lanes step = std::sqrt(2.0) * law_.ratio[law_.surfaces] * height(mean_.stress) / n;
  const Lanes crossings = smaller(1.0 + 3.0 * stress / step, all(n));
  const Lanes by_shear = octahedral_strain(increment) / largest_part;
  const Lanes by_volume = magnitude(volume) / 3.0 / largest_part;
  return larger(all(1.0), floor(larger(crossings, larger(by_shear, by_volume))));
}

Lanes Step::take(const Lanes& volume, const Deviators3& increment) {
  const Stiffness moduli = stiffness(committed_height_);
  const MeanStress trial = strained(mean_, moduli.bulk, volume);
  const Deviators3 trial_deviator = s_ + 2.0 * moduli.shear * increment;
  reverse_if_unloading(present_, trial, trial_deviator);
  Lanes work{};
  const LaneMask elastic = present_ & in_core(trial_deviator, height(trial.stress));
  const LaneMask plastic = present_ & ~elastic;
  if (any(plastic)) {
    const IncrementStart start = begin(increment);
    const Lanes count = parts(moduli.factor, volume, increment);
    const Lanes share = 1.0 / count;
    LaneMask going = plastic;
    for (double k = 1.0; any(going); k += 1.0) {
      work += part(going, start, share * volume, share * increment);
      going &= count > k;
    }
  }
  s_ = choose(elastic, trial_deviator, s_);
  mean_ = choose(elastic, trial, mean_);
  state_.volume_strain = choose(elastic, state_.volume_strain + volume, state_.volume_strain);
  state_.strain = choose(elastic, state_.strain + increment, state_.strain);
  state_.active_surface = active_.index();
  state_.active_centre = choose(active_.inside_all(), state_.active_centre, active_.cone().centre);
  state_.gap = mean_.gap;
  state_.largest_pressure = larger(state_.largest_pressure, -mean_.stress);
  return work;
}

Lanes Step::part(const LaneMask& which, const IncrementStart& start, const Lanes& volume,
                 const Deviators3& increment) {
  const Stiffness moduli = stiffness(height(mean_.stress));
  const MeanStress trial = strained(mean_, moduli.bulk, volume);
  const Deviators3 trial_deviator = s_ + 2.0 * moduli.shear * increment;
  FlowStress flow;
  flow.start_volume = state_.volume_strain;
  flow.volume = state_.volume_strain + volume;
  state_.volume_strain = choose(which, flow.volume, state_.volume_strain);
  const FlowStrain strain = {state_.strain + increment, octahedral_strain(increment)};
  state_.strain = choose(which, strain.end, state_.strain);

  reverse_if_unloading(which, trial, trial_deviator);
  const LaneMask elastic = which & in_core(trial_deviator, height(trial.stress));
  const LaneMask plastic = which & ~elastic;
  const Deviators3 first = s_;
  const Lanes first_mean = mean_.stress;
  s_ = choose(elastic, trial_deviator, s_);
  mean_ = choose(elastic, trial, mean_);
  if (!any(plastic))
    return Lanes{};
  if (const LaneMask free = plastic & active_.inside_all(); any(free))
    active_.advance(free);
  flow.start = first;
  flow.start_height = height(first_mean);
  flow.trial = trial_deviator;
  correct(plastic, start, moduli, flow, strain, trial);
  const Lanes work = 0.5 * dot(first + s_, trial_deviator - s_) / (2.0 * moduli.shear) +
                     0.5 * (first_mean + mean_.stress) * (trial.stress - mean_.stress) / moduli.bulk;
  return choose(plastic, work, Lanes{});
}

/// A, with the flow changed where it would make A smaller than half the plastic modulus.
Lanes Step::consistency(Lanes& flow, const Stiffness& moduli, const MeanAndDeviators& normal) const {
  const Lanes plastic = moduli.factor * active_.plastic_modulus();
  const Lanes least = moduli.factor * active_.least_modulus();
  const Lanes shear = 2.0 * moduli.shear * dot(normal.deviator, normal.deviator);
  const Lanes volumetric = 9.0 * moduli.bulk * normal.mean;
  const Lanes a = shear + volumetric * flow + plastic;
  const LaneMask enough = a >= least;
  if (any(~enough)) // not 0: a is below shear + plastic
    flow = choose(enough, flow, (least - shear - plastic) / volumetric);
  return larger(least, a);
}

void Step::correct(LaneMask which, const IncrementStart& start, const Stiffness& moduli, FlowStress flow,
                   const FlowStrain& strain, MeanStress trial) {
  Lanes beyond = all(1.0); // the part of what lies beyond a surface that is still to be corrected
  for (;;) {
    flow.height = height(trial.stress);
    const YieldCones& cone = active_.cone();
    flow.contact = cone.projected(flow.trial, flow.height);
    const MeanAndDeviators normal = cone.normal(flow.contact, flow.height);
    Lanes volumetric = volumetric_flow(law_, state_, which, start, flow, strain);
    const Lanes a = consistency(volumetric, moduli, normal);
    const Lanes multiplier = beyond * positive(dot(normal.deviator, flow.trial - flow.contact)) / a;
    const Lanes plastic_volume = 3.0 * volumetric * multiplier;
    const Lanes closed = smaller(positive(plastic_volume), trial.gap);
    MeanStress mean = {trial.stress - moduli.bulk * (plastic_volume - closed), trial.gap - closed};
    Lanes deviatoric = all(1.0);
    if (const LaneMask stops = mean.stress > 0.0; any(stops)) { // flow stops at zero effective stress
      deviatoric = choose(stops, trial.stress / (trial.stress - mean.stress), deviatoric);
      mean.stress = choose(stops, Lanes{}, mean.stress);
    }
    Deviators3 s = flow.trial - (2.0 * moduli.shear * multiplier * deviatoric) * normal.deviator;
    const Lanes now = height(mean.stress);
    const LaneMask on_failure = active_.on_failure();
    if (const LaneMask off = on_failure | (cone.yield_function(s, now) < 0.0); any(which & off))
      s = choose(off, cone.projected(s, now), s);
    s_ = choose(which, s, s_);
    mean_ = choose(which, mean, mean_);
    which &= ~on_failure;
    if (!any(which))
      return;
    const YieldCones next = active_.next();
    const LaneMask crosses = which & ~(next.yield_function(s, now) <= 0.0);
    active_.move(which & ~crosses, translated_centre(cone, next, s, now));
    if (!any(crosses))
      return;
    // The part beyond was corrected with the modulus of the previous surface.
    const Lanes before = active_.plastic_modulus();
    active_.advance(crosses);
    beyond = (before - active_.plastic_modulus()) / before;
    flow.trial = s;
    trial = mean;
    which = crosses;
  }
}

/// Advances one to four points from i on.
template <typename Group>
void advance(const Pdmy03& law, const Points& points, std::size_t i, Group group) {
  const std::size_t size = pdmy03_state_size(law.surfaces);
  double* const blocks = points.state + i * size;
  auto state = load_four<Pdmy03States>(blocks, size, group.count);
  const FourTurned here = turned(points, i, group, state.rotation);
  state.rotation = here.angle;
  const auto resting = [&](std::size_t lane) {
    return RestingCentres(blocks + (lane < group.count ? lane * size : 0), law.surfaces);
  };
  const Lanes out_of_plane = points.dezz == nullptr ? Lanes{} : group.load(points.dezz + i);
  const MeanAndDeviators increment = split(here.strain.xx, here.strain.yy, out_of_plane, here.strain.xy);
  Step step(law, state, {resting(0), resting(1), resting(2), resting(3)},
            split(here.stress.xx, here.stress.yy, group.load(points.szz + i), here.stress.xy),
            group.present(all(1.0), Lanes{}) > 0.0);
  const Lanes work = step.take(3.0 * increment.mean, increment.deviator);
  const auto end = components(step.stress());
  store_response(points, i, group, here.axes.to_space({end.xx, end.yy, end.xy}), end.zz, work);
  store_four(state, blocks, size, group.count);
}

} // namespace

void update(const Pdmy03& law, const Points& points) {
  check_increments("pdmy03", points, pdmy03_largest_increment);
  // The centres of resting surfaces, half of a block, are floats that the law itself has written.
  check_finite("pdmy03", points, pdmy03_state_size(law.surfaces), pdmy03_fixed_size);
  by_fours(0, points.count, [&](std::size_t i, auto group) { advance(law, points, i, group); });
}

} // namespace tremolo::materials
