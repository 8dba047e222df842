#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// [random_profile]
Table random_profile_keys();

} // namespace tremolo::scene
