#include "scene/plan/rest/fast_rest.hpp"
#include "scene/plan/wave/arrival.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tremolo::scene {

namespace {

/// Pi at which settlement errs by 2.5 % of what the rest adds.
constexpr double largest_slow_wave = 0.1;
/// m/s; beyond it the drag that takes the velocity of water relative to the grains needs more than 2 ms.
constexpr double largest_permeability = 1e-2;
/// Of the periods in which pressure rings: how many the factor must take to rise.
constexpr double periods_to_rise = 20.0;

void look_for_motion(const Case& scene, Findings& findings) {
  const double end = arrival_of_intensity(scene, 0.99);
  if (scene.shaking.duration < end)
    findings.add(
        "stage",
        fmt::format("the rest begins at {:g} s, and 99 % of the motion's Arias intensity has arrived at "
                    "{:.3g} s only: what is left of the motion acts on ground in which water flows {:g} "
                    "times as easily, and stands in the results {:g} times as long",
                    scene.shaking.duration, end, scene.rest->time_factor, scene.rest->time_factor));
}

/// A recording and a program of one's own are not sped up.
void look_for_other_fields(const Case& scene, Findings& findings) {
  const auto& [sides, left, right, base] = scene.boundary;
  for (const auto& [key, model] :
       {std::pair{"boundary.left", left.field.model}, std::pair{"boundary.right", right.field.model},
        std::pair{"boundary.base", base.field.model}})
    if (model == SourceModel::recording || model == SourceModel::external)
      findings.add(key, fmt::format("the free field must have the same rest, at {:g} s, with the same "
                                    "'time_factor' = {:g}, which cannot be checked here",
                                    scene.shaking.duration, scene.rest->time_factor));
}

} // namespace

void time_factor_is_allowed(const Case& scene, Findings& findings) {
  if (!scene.rest || !(scene.rest->time_factor > 1.0) || !findings.sound("stage") ||
      !findings.sound("water") || !findings.sound("soil") || !findings.sound("mesh"))
    return;
  const auto refuse = [&](const std::string& why) {
    findings.add("stage", fmt::format("the rest's 'time_factor' = {:g} {}", scene.rest->time_factor, why));
  };
  if (scene.damping.model == DampingModel::rayleigh)
    refuse(
        "does not go with [damping] model = \"rayleigh\", whose part in proportion to mass would resist the "
        "soil as many times as much");
  const std::optional<FastRest> fast = fast_rest(scene);
  if (!fast) {
    refuse("has nothing to speed up: no soil below the water table lets water flow");
    return;
  }
  const auto at_most = [&](double share) {
    const double allowed = scene.rest->time_factor * share;
    return allowed > 1.0 ? fmt::format("at most {:.3g}", allowed) : "none, that is 1";
  };
  if (fast->slow_wave > largest_slow_wave)
    refuse(fmt::format(
        "is too large: inertia counts in what drains, and the settlement that the rest adds would be "
        "off by {:.2g} %; allowed for this ground: {}",
        100.0 * fast->settlement_error(), at_most(largest_slow_wave / fast->slow_wave)));
  if (fast->permeability > largest_permeability)
    refuse(fmt::format(
        "is too large: it makes soil '{}' let water flow by {:.3g} m/s, and beyond {:g} m/s water "
        "does not follow Darcy's law at once; allowed: {}",
        fast->most_permeable, fast->permeability, largest_permeability,
        at_most(largest_permeability / fast->permeability)));
  if (periods_to_rise * fast->ringing > materials::RestClock::rise)
    refuse(
        fmt::format("rises within {:g} s, in which the pressure of this ground, with a period of {:.3g} s, "
                    "would ring; allowed: periods up to {:g} s",
                    materials::RestClock::rise, fast->ringing, materials::RestClock::rise / periods_to_rise));
}

void time_factor_errs_little(const Case& scene, Findings& findings) {
  constexpr double small_error = 0.002; // of the settlement
  const std::optional<FastRest> fast = fast_rest(scene);
  if (!fast)
    return;
  look_for_motion(scene, findings);
  look_for_other_fields(scene, findings);
  if (fast->settlement_error() > small_error)
    findings.add(
        "stage",
        fmt::format("the rest's 'time_factor' = {:g} makes inertia count: the settlement that the "
                    "rest adds will be off by about {:.2g} %; {:.3g} would keep it below {:g} %",
                    scene.rest->time_factor, 100.0 * fast->settlement_error(),
                    scene.rest->time_factor * std::pow(small_error / 0.8, 1.0 / 1.5) / fast->slow_wave,
                    100.0 * small_error));
}

} // namespace tremolo::scene
