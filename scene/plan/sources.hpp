#pragma once

#include "scene/plan/plan.hpp"

#include <string>
#include <vector>

namespace tremolo::scene {

/// The free-field processes of a case; each side is served by exactly one.
std::vector<SourceProcess> plan_sources(const Case& scene);

/// A text on the field that the base uses.
std::string describe_base(const Case& scene, const std::vector<SourceProcess>& sources);

/// Index of the source that serves a side.
std::size_t source_index(const std::vector<SourceProcess>& sources, Side side);

} // namespace tremolo::scene
