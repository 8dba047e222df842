#include "materials/law/driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace tremolo::materials {
namespace {

constexpr int deepest_cut = 12; // halvings of one step

Components components(const PointStress& stress) {
  return {stress.xx, stress.yy, stress.xy, stress.zz};
}

double largest(const PointStress& stress) {
  return std::max({std::abs(stress.xx), std::abs(stress.yy), std::abs(stress.zz), std::abs(stress.xy)});
}

bool finite(const PointStress& stress) {
  return std::isfinite(stress.xx) && std::isfinite(stress.yy) && std::isfinite(stress.zz) &&
         std::isfinite(stress.xy);
}

MixedStep mixed(const PointStep& step) {
  MixedStep all;
  std::size_t i = 0;
  for (const Control& control : {step.xx, step.yy, step.xy, step.zz}) {
    all.by_stress[i] = control.by_stress();
    all.value[i] = control.value();
    ++i;
  }
  all.pore_stiffness = step.pore_stiffness;
  return all;
}

/// The first half of a step from a given stress.
MixedStep first_half(MixedStep step, const Components& stress) {
  for (std::size_t i = 0; i < step.value.size(); ++i)
    step.value[i] = 0.5 * (step.value[i] + (step.by_stress[i] ? stress[i] : 0.0));
  return step;
}

/// The second half of a step, after the first half has compressed the water by `volume`.
MixedStep second_half(MixedStep step, double volume) {
  for (std::size_t i = 0; i < step.value.size(); ++i)
    if (!step.by_stress[i])
      step.value[i] *= 0.5;
    else if (i != 2)
      step.value[i] -= step.pore_stiffness * volume;
  return step;
}

/// Without strain increments.
Points only_point(PointState& point) {
  Points points;
  points.count = 1;
  points.sxx = &point.stress.xx;
  points.syy = &point.stress.yy;
  points.szz = &point.stress.zz;
  points.sxy = &point.stress.xy;
  points.state = point.variables.data();
  points.plastic_work = &point.plastic_work;
  return points;
}

} // namespace

PointTest::PointTest(const Law& law, const PointStress& initial, const StressTolerance& tolerance)
    : law_(law), tolerance_(tolerance), three_dimensional_(traits(law).three_dimensional) {
  validate(law_);
  now_.stress = initial;
  now_.variables.resize(state_variables(law_).size());
  initialise(law_, only_point(now_));
}

void PointTest::advance(PointState& point, const Components& strain, double rotation) {
  Points points = only_point(point);
  points.dexx = &strain[0];
  points.deyy = &strain[1];
  points.dgxy = &strain[2];
  points.dwxy = &rotation;
  points.dezz = strain[3] == 0.0 ? nullptr : &strain[3];
  ++updates_;
  update(law_, points);
  if (!finite(point.stress)) {
    throw std::runtime_error(
        fmt::format("{}: the stress after strain increments ({:g}, {:g}, {:g}, {:g}) in xx, "
                    "yy, xy, zz is not finite",
                    name(law_), strain[0], strain[1], strain[2], strain[3]));
  }
  point.strain.xx += strain[0];
  point.strain.yy += strain[1];
  point.strain.xy += strain[2];
  point.strain.zz += strain[3];
}

bool PointTest::solve(const MixedStep& step, double rotation, double tolerance) {
  std::optional<Components> last; // what trial_ has been strained by
  const StressAfter stress_after = [&](const Components& strain, Components& stress) {
    last.reset();
    trial_ = now_;
    try {
      advance(trial_, strain, rotation);
    } catch (const std::exception& refusal) {
      refusal_ = refusal.what();
      return false;
    }
    last = strain;
    stress = components(trial_.stress);
    return true;
  };
  const double level = largest(now_.stress);
  const double wanted = std::max(tolerance_.wanted, 1e-13 * level);
  const double accepted = std::max(wanted, tolerance_.accepted * level);
  const MixedControl::Found found = control_.find(step, stress_after, wanted, accepted);
  missing_ = found.missing;
  if (!(found.missing <= std::max(wanted, tolerance * level)))
    return false;
  Components stress;
  if (found.strain != last && !stress_after(found.strain, stress))
    return false;
  std::swap(now_, trial_);
  count_leap(found);
  return true;
}

void PointTest::count_leap(const MixedControl::Found& found) {
  if (found.away)
    ++leaps_.steps_away;
  if (found.leap > 0.0) {
    if (leaps_.count == 0)
      leaps_.first = now_.strain;
    ++leaps_.count;
    leaps_.largest = std::max(leaps_.largest, found.leap);
  }
}

void PointTest::solve_in_halves(const MixedStep& step, double rotation, int depth) {
  if (solve(step, rotation, tolerance_.accepted))
    return;
  if (depth == deepest_cut) {
    throw std::runtime_error(fmt::format("no strain gives the prescribed stress: {:.3g} Pa is missing after "
                                         "the step was cut {} times in halves; the "
                                         "point may have passed its peak load{}{}",
                                         missing_, deepest_cut,
                                         refusal_.empty() ? "" : "; the law says: ", refusal_));
  }
  const PointStrain before = now_.strain;
  solve_in_halves(first_half(step, components(now_.stress)), 0.5 * rotation, depth + 1);
  const double volume =
      (now_.strain.xx - before.xx) + (now_.strain.yy - before.yy) + (now_.strain.zz - before.zz);
  solve_in_halves(second_half(step, volume), 0.5 * rotation, depth + 1);
}

bool PointTest::take_nearest(const MixedStep& step, double rotation) {
  if (!(tolerance_.nearest > 0.0) || !solve(step, rotation, tolerance_.nearest))
    return false;
  largest_missing_ = std::max(largest_missing_, missing_);
  return true;
}

void PointTest::apply(const PointStep& step) {
  const MixedStep all = mixed(step);
  if (!three_dimensional_ && (all.by_stress[3] || all.value[3] != 0.0)) {
    throw std::invalid_argument(
        fmt::format("{} is a law of plane strain: it takes no out-of-plane strain", name(law_)));
  }
  if (std::none_of(all.by_stress.begin(), all.by_stress.end(), [](bool free) { return free; })) {
    trial_ = now_;
    advance(trial_, all.value, step.rotation);
    std::swap(now_, trial_);
    return;
  }
  const PointState start = now_;
  refusal_.clear();
  try {
    solve_in_halves(all, step.rotation, 0);
  } catch (...) {
    now_ = start;
    if (!take_nearest(all, step.rotation))
      throw;
  }
}

} // namespace tremolo::materials
