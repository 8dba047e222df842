#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// [[stage]]
Table stage_table();

} // namespace tremolo::scene
