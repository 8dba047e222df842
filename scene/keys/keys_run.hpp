#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// Tables of coupling, output and verification.
std::vector<Table> run_keys();

} // namespace tremolo::scene
