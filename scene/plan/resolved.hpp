#pragma once

#include "scene/plan/plan.hpp"

#include <string>

namespace tremolo::scene {

/// A case as it is understood, as JSON: every value in force and where it comes from, the plan, and what each
/// source has to serve, with levels (m) and times (s).
std::string resolved_json(const Case& scene, const Plan& plan);

} // namespace tremolo::scene
