#include "scene/levels.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void time_step_is_stable(const Case& scene, Findings& findings) {
  if (!scene.time.dt || !findings.sound("time.dt") || !mesh_is_sound(scene, findings))
    return;
  const double limit = critical_time_step(scene, levels(scene));
  if (*scene.time.dt > limit)
    findings.add("time.dt",
                 fmt::format("'dt' = {} exceeds the critical step 0.65 h/c_p = {:.6g} s of this mesh and its "
                             "fastest soil",
                             *scene.time.dt, limit));
}

} // namespace tremolo::scene
