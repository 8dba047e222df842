#pragma once

#include "scene/case.hpp"

#include <optional>
#include <string>

namespace tremolo::app {

/// The reason why the exact half-space field is not the solution of this case; empty if it is: level ground
/// up to one free surface on both sides, without layers, all soil linear elastic and equal to the half-space.
std::optional<std::string> why_not_exact(const scene::Case& scene);

} // namespace tremolo::app
