#pragma once

#include "scene/case.hpp"

#include <string>

namespace tremolo::app {

/// A text on the flow of a case with [water] seepage: discharge, the place where water leaves the ground, and
/// the steepest upward gradient. Empty for a case without.
std::string seepage_text(const scene::Case& scene);

} // namespace tremolo::app
