#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// The keys of a range among the axes of a study, `{ low = ..., high = ..., scale = ... }`.
const Table& range_keys();
/// The keys of a count among the axes of a study, `{ count = ... }`.
const Table& count_keys();

} // namespace tremolo::scene
