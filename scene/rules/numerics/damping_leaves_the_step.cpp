#include "scene/plan/step/step_limit.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void damping_leaves_the_step(const Case& scene, Findings& findings) {
  const StepLimit limit = step_limit(scene, levels(scene));
  const bool constant = scene.damping.model == DampingModel::constant;
  if (limit.undamped <= (constant ? 1.15 : 1.001) * limit.dt)
    return;
  findings.add("damping.model",
               fmt::format("{} damping sets the time step: the critical step is {:.3g} s, that of {} on "
                           "cells of {} m, and {:.3g} s without damping, {:.3g} times as long; {}",
                           constant ? "constant" : "viscous", limit.dt, limit.by, limit.cell_size,
                           limit.undamped, limit.undamped / limit.dt,
                           constant ? "a smaller damping ratio shortens it less"
                                    : "a smaller damping ratio or a higher frequency shortens it less, and "
                                      "model = \"constant\" by a few per cent"));
}

} // namespace tremolo::scene
