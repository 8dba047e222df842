// Sand that has liquefied reconsolidates with a stiffness that its law has in a rest alone. It acts only on
// the pressure that is left when the rest begins, so that the rest should begin when strong motion ends.

#include "scene/plan/wave/arrival.hpp"
#include "scene/plan/wet_soils.hpp"
#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace tremolo::scene {

namespace {

/// Strong motion lasts until this fraction of the Arias intensity has arrived.
constexpr double goes_on = 0.95;
/// A delay that changes the settlement by a few per cent at most, s.
constexpr double delay_allowed = 1.0;

std::string reconsolidating_soils(const Case& scene) {
  std::string names;
  for (const Soil& soil : one_of_each_name(soils_below_table(scene)))
    if (materials::traits(soil.law).reconsolidates && lets_water_flow(soil))
      names += fmt::format("{}'{}'", names.empty() ? "" : ", ", soil.name);
  return names;
}

/// Looks whether the stage after a shaking begins when strong motion ends.
void end_suits_motion(const Case& scene, const ShakingMotion& shaking, const std::string& sand,
                      Findings& findings) {
  const TimedStage& stage = scene.timed[shaking.stage];
  const bool then_rests = scene.rest_after(shaking) != nullptr;
  const double end = arrival_of_intensity(scene, shaking, strong_motion_over);
  if (stage.end() > end + delay_allowed)
    findings.add(
        "stage",
        fmt::format("{:.0f} % of the motion's Arias intensity has arrived at {:.3g} s, and the {} stage "
                    "lasts until {:g} s: meanwhile soil {} drains as if it had not been shaken, which gives "
                    "too little settlement and too short a time under pressure. {} (docs/stages.md)",
                    100.0 * strong_motion_over, end, stage.name, stage.end(), sand,
                    then_rests
                        ? fmt::format("Let the rest begin at about {:.0f} s", std::ceil(end))
                        : fmt::format("End the shaking at about {:.0f} s, and add a [[stage]] of kind = "
                                      "\"rest\" for what follows",
                                      std::ceil(end))));
  else if (const double nearly = arrival_of_intensity(scene, shaking, goes_on);
           then_rests && stage.end() < nearly)
    findings.add("stage",
                 fmt::format("the rest begins at {:g} s, before {:.0f} % of the motion's Arias intensity has "
                             "arrived, at {:.3g} s: soil {} is still shaken when it takes on the stiffness "
                             "of sand that reconsolidates; a longer shaking stage avoids it",
                             stage.end(), 100.0 * goes_on, nearly, sand));
}

} // namespace

void shaken_sand_rests(const Case& scene, Findings& findings) {
  const std::string sand = reconsolidating_soils(scene);
  if (sand.empty() || scene.timed.empty())
    return;
  for (const ShakingMotion& shaking : scene.motion.shakings)
    end_suits_motion(scene, shaking, sand, findings);
}

} // namespace tremolo::scene
