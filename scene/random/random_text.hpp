#pragma once

#include "scene/case.hpp"

#include <string>

namespace tremolo::scene {

/// The realisation of a case with [random_profile]: its parameters, then factor, Vs and soil of each layer of
/// [[profile]].
std::string random_profile_text(const Case& scene);

} // namespace tremolo::scene
