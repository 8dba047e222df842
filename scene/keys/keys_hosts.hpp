#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// Tables of the processes that run on other machines.
std::vector<Table> hosts_keys();

} // namespace tremolo::scene
