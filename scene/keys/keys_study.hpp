#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// The keys of a range among the axes of a study, `{ low = ..., high = ..., scale = ... }`.
const Table& range_keys();

} // namespace tremolo::scene
