#include "mpm_domain/spec/limits.hpp"
#include "scene/plan/step/step_limit.hpp"
#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"
#include "scene/soils/viscous_damping.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

using mpm_domain::usl_share;

namespace {

/// Nobody waits for more.
constexpr double most_steps = 1e9;

void steps_can_be_counted(const Case& scene, Findings& findings) {
  if (!findings.sound("time") || !findings.sound("stage") || !findings.sound("soil") || scene.soils.empty() ||
      !mesh_is_sound(scene, findings) || !findings.sound("time.dt") || !findings.sound("time.fraction"))
    return;
  const double dt =
      scene.time.dt ? *scene.time.dt : scene.time.fraction * critical_time_step(scene, levels(scene));
  const double steps = scene.end() / dt;
  if (steps > most_steps)
    findings.add(scene.time.dt ? "time.dt" : "time.fraction",
                 fmt::format("steps of {:.3g} s make {:.3g} for the {} s of the run, must be at most {:g}",
                             dt, steps, scene.end(), most_steps));
}

} // namespace

void time_step_is_stable(const Case& scene, Findings& findings) {
  steps_can_be_counted(scene, findings);
  const bool usl = scene.time.order == StepOrder::usl && findings.sound("time.order");
  if (!scene.time.dt) {
    if (usl && scene.time.fraction > usl_share && findings.sound("time.fraction"))
      findings.add("time.fraction",
                   fmt::format("'fraction' = {} is not stable with order = \"usl\"; allowed: "
                               "at most {}",
                               scene.time.fraction, usl_share));
    return;
  }
  if (!findings.sound("time.dt") || !mesh_is_sound(scene, findings))
    return;
  const double critical = critical_time_step(scene, levels(scene));
  const bool damped = std::ranges::any_of(
      domain_soils(scene), [&](const Soil& soil) { return damping_time(scene.damping, soil.damping) > 0.0; });
  const double h = contact_cell_size(scene);
  const bool by_structure = std::ranges::any_of(scene.structures, [&](const Structure& structure) {
    return structure.stiffness && critical_step(structure, h) <= critical;
  });
  if (*scene.time.dt > critical)
    findings.add(
        "time.dt",
        fmt::format(
            "'dt' = {} exceeds the critical step {} = {:.6g} s of this mesh and its {}", *scene.time.dt,
            damped && !by_structure ? "sqrt(t^2 + beta^2) - beta, t = 0.65 h/c_p," : "0.65 h/c_p", critical,
            by_structure              ? "elastic structures"
            : damped                  ? "soils with their viscous damping"
            : domain_is_damped(scene) ? "fastest soil, with its constant damping"
                                      : "fastest soil"));
  else if (usl && *scene.time.dt > usl_share * critical)
    findings.add("time.dt",
                 fmt::format("'dt' = {} is not stable with order = \"usl\"; allowed: at most {} of "
                             "the critical step, {:.6g} s",
                             *scene.time.dt, usl_share, usl_share * critical));
}

} // namespace tremolo::scene
