#include "scene/plan/rest/fast_rest.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

/// Pi at which settlement errs by 2.5 % of what the rest adds.
constexpr double largest_slow_wave = 0.1;
/// m/s; beyond it the drag that takes the velocity of water relative to the grains needs more than 2 ms.
constexpr double largest_permeability = 1e-2;
/// The time factor must rise over at least this many natural periods of the pore pressure.
constexpr double periods_to_rise = 20.0;

} // namespace

void time_factor_is_allowed(const Case& scene, Findings& findings) {
  const TimedStage* const stage = scene.fastest_rest();
  if (stage == nullptr || !(stage->rest->time_factor > 1.0) || !findings.sound("stage") ||
      !findings.sound("water") || !findings.sound("soil") || !findings.sound("mesh"))
    return;
  const double factor = stage->rest->time_factor;
  const auto refuse = [&](const std::string& why) {
    findings.add("stage", fmt::format("the rest's 'time_factor' = {:g} {}", factor, why));
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
    const double allowed = factor * share;
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
  if (periods_to_rise * fast->ringing > materials::SoilClock::rise)
    refuse(
        fmt::format("rises within {:g} s, in which the pressure of this ground, with a period of {:.3g} s, "
                    "would ring; allowed: periods up to {:g} s",
                    materials::SoilClock::rise, fast->ringing, materials::SoilClock::rise / periods_to_rise));
}

} // namespace tremolo::scene
