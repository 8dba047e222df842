#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/rest/fast_rest.hpp"
#include "scene/plan/wave/arrival.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace tremolo::scene {

namespace {

void look_for_motion(const Case& scene, Findings& findings) {
  for (const ShakingMotion& shaking : scene.motion.shakings) {
    const TimedStage* const next = scene.rest_after(shaking);
    if (next == nullptr || !(next->rest->time_factor > 1.0))
      continue;
    const double end = arrival_of_intensity(scene, shaking, strong_motion_over);
    if (next->start < end)
      findings.add(
          "stage",
          fmt::format("the {} begins at {:g} s, and 99 % of the motion's Arias intensity has arrived at "
                      "{:.3g} s only: what is left of the motion acts on ground in which water flows {:g} "
                      "times as easily, and stands in the results {:g} times as long",
                      next->name, next->start, end, next->rest->time_factor, next->rest->time_factor));
  }
}

/// A recording and a program of one's own are not sped up.
void look_for_other_fields(const Case& scene, const TimedStage& fastest, Findings& findings) {
  const auto& [sides, left, right, base] = scene.boundary;
  for (const auto& [key, model] :
       {std::pair{"boundary.left", left.field.model}, std::pair{"boundary.right", right.field.model},
        std::pair{"boundary.base", base.field.model}})
    if (traits(model).from_outside)
      findings.add(key, fmt::format("the free field must have the same rest, at {:g} s, with the same "
                                    "'time_factor' = {:g}, which cannot be checked here",
                                    fastest.start, fastest.rest->time_factor));
}

} // namespace

void time_factor_errs_little(const Case& scene, Findings& findings) {
  constexpr double small_error = 0.002; // of the settlement
  const std::optional<FastRest> fast = fast_rest(scene);
  if (!fast)
    return;
  look_for_motion(scene, findings);
  const TimedStage& fastest = *scene.fastest_rest();
  look_for_other_fields(scene, fastest, findings);
  const double factor = fastest.rest->time_factor;
  if (fast->settlement_error() > small_error)
    findings.add("stage",
                 fmt::format("the rest's 'time_factor' = {:g} makes inertia count: the settlement that the "
                             "rest adds will be off by about {:.2g} %; {:.3g} would keep it below {:g} %",
                             factor, 100.0 * fast->settlement_error(),
                             factor * std::pow(small_error / 0.8, 1.0 / 1.5) / fast->slow_wave,
                             100.0 * small_error));
}

} // namespace tremolo::scene
