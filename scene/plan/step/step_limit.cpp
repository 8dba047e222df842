#include "scene/plan/step/step_limit.hpp"

#include "mpm_domain/spec/limits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/prop/props.hpp"
#include "scene/plan/structures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tremolo::scene {

namespace {

/// The critical step of a material on the cells where it is smallest.
struct Allowed {
  std::string who;
  double cell_size = 0.0;
  MaterialStep step;
};

std::vector<Allowed> allowed_steps(const Case& scene, std::span<const Level> levels) {
  std::vector<Allowed> all;
  const auto add = [&](const std::string& who, double cell_size, MaterialStep step) {
    auto known = std::ranges::find(all, who, &Allowed::who);
    if (known == all.end())
      known = all.insert(known, {who, cell_size, step});
    if (step.critical < known->step.critical)
      *known = {who, cell_size, {step.critical, known->step.undamped}};
    known->step.undamped = std::min(known->step.undamped, step.undamped);
  };
  double steps = 1.0; // of a level in one of the coarsest
  for (const Level& level : levels) {
    for (const auto& [who, step] : level.steps)
      add(who, level.cell_size, {steps * step.critical, steps * step.undamped});
    if (scene.time.subcycle)
      steps *= 2.0;
  }
  const auto below = ground_below_base(scene);
  if (below && scene.boundary.base.absorber == Absorber::matched_layer) {
    const double step = mpm_domain::largest_courant_number * scene.mesh.size / below->p_wave_speed();
    add("the ground below the base", scene.mesh.size, {step, step});
  }
  for (const PlannedProp& prop : plan_props(scene))
    add(fmt::format("prop '{}'", prop.name), contact_cell_size(scene),
        {prop.critical_step, prop.critical_step});
  return all;
}

} // namespace

StepLimit step_limit(const Case& scene, std::span<const Level> levels) {
  constexpr double none = std::numeric_limits<double>::infinity();
  StepLimit limit{.dt = none, .by = {}, .cell_size = 0.0, .others = none, .undamped = none};
  for (const Allowed& allowed : allowed_steps(scene, levels)) {
    limit.undamped = std::min(limit.undamped, allowed.step.undamped);
    if (allowed.step.critical < limit.dt) {
      limit.others = limit.dt;
      limit.dt = allowed.step.critical;
      limit.by = allowed.who;
      limit.cell_size = allowed.cell_size;
    } else {
      limit.others = std::min(limit.others, allowed.step.critical);
    }
  }
  return limit;
}

double critical_time_step(const Case& scene, std::span<const Level> levels) {
  return step_limit(scene, levels).dt;
}

std::string step_limit_text(const StepLimit& limit) {
  std::string text = fmt::format("set by {} on cells of {} m", limit.by, limit.cell_size);
  const char* between = "; ";
  if (std::isfinite(limit.others)) {
    text += fmt::format("{}{:.4g} s without it", between, limit.others);
    between = ", ";
  }
  if (limit.undamped > limit.dt)
    text += fmt::format("{}{:.4g} s without damping", between, limit.undamped);
  return text;
}

} // namespace tremolo::scene
