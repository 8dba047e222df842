#pragma once

#include "scene/case.hpp"

#include <string>

namespace tremolo::app {

/// What the flow of a case with [water] seepage is, in words: discharge, where water leaves the ground, and
/// where it rises most steeply. Empty for a case without.
std::string seepage_text(const scene::Case& scene);

} // namespace tremolo::app
