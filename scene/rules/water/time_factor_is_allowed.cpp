#include "scene/plan/rest/fast_rest.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

/// Pi at which settlement errs by 2.5 % of what the rest adds.
constexpr double largest_slow_wave = 0.1;
/// m/s; beyond it the drag that takes the velocity of water relative to the grains needs more than 2 ms.
constexpr double largest_permeability = 1e-2;
/// Of the periods in which pressure rings: how many the factor must take to rise.
constexpr double periods_to_rise = 20.0;

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
  if (fast->slow_wave > largest_slow_wave || fast->permeability > largest_permeability)
    refuse(
        fmt::format("is too large: inertia counts then, and water would not follow Darcy's law; allowed for "
                    "this ground: at most {:.3g}",
                    scene.rest->time_factor * std::min(largest_slow_wave / fast->slow_wave,
                                                       largest_permeability / fast->permeability)));
  if (periods_to_rise * fast->ringing > materials::RestClock::rise)
    refuse(
        fmt::format("rises within {:g} s, in which the pressure of this ground, with a period of {:.3g} s, "
                    "would ring; allowed: periods up to {:g} s",
                    materials::RestClock::rise, fast->ringing, materials::RestClock::rise / periods_to_rise));
}

void time_factor_errs_little(const Case& scene, Findings& findings) {
  constexpr double small_error = 0.002; // of the settlement
  const std::optional<FastRest> fast = fast_rest(scene);
  if (fast && fast->settlement_error() > small_error)
    findings.add(
        "stage",
        fmt::format("the rest's 'time_factor' = {:g} makes inertia count: the settlement that the "
                    "rest adds will be wrong by about {:.2g} %; {:.3g} would keep it below {:g} %",
                    scene.rest->time_factor, 100.0 * fast->settlement_error(),
                    scene.rest->time_factor * std::pow(small_error / 0.8, 1.0 / 1.5) / fast->slow_wave,
                    100.0 * small_error));
}

} // namespace tremolo::scene
