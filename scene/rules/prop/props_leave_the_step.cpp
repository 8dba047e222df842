#include "scene/plan/prop/props.hpp"
#include "scene/plan/step/step_limit.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::scene {

void props_leave_the_step(const Case& scene, Findings& findings) {
  if (scene.props.empty())
    return;
  Case without = scene;
  without.props.clear();
  const double of_others = critical_time_step(without, levels(without));
  const std::vector<PlannedProp> planned = plan_props(scene);
  for (std::size_t n = 0; n < planned.size(); ++n) {
    if (planned[n].critical_step > of_others)
      continue;
    const double share = planned[n].critical_step / of_others;
    findings.add(
        scene.props[n].path + ".stiffness",
        fmt::format("'stiffness' = {:g} N/m2 sets the time step: the prop '{}' allows about {:.2g} s, "
                    "all else {:.2g} s; {:.2g} N/m2 would not",
                    scene.props[n].stiffness, planned[n].name, planned[n].critical_step, of_others,
                    scene.props[n].stiffness * share * share));
  }
}

} // namespace tremolo::scene
