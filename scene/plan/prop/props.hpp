#pragma once

// The props of a case, as the plan describes them. The time step that a prop allows follows from what its
// ends hold (mpm_domain/prop/props.hpp); here the particles there stand in their lattice, and a rigid
// structure has the least mass that a convex one has at a point of its outline, a quarter of its own.

#include "scene/case.hpp"

#include <string>
#include <vector>

namespace tremolo::scene {

struct PlannedProp {
  std::string name;
  double length = 0.0;        ///< m
  double critical_step = 0.0; ///< s, about
};

/// Requires a case whose mesh, structures and props have been read.
std::vector<PlannedProp> plan_props(const Case& scene);

/// "'strut' ...; ..."
std::string props_effect_text(const Case& scene);

/// Some lines for each prop.
std::string props_text(const Case& scene, const std::vector<PlannedProp>& props);

} // namespace tremolo::scene
