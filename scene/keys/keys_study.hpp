#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// The keys of a range among the axes of a study, `{ low = ..., high = ..., scale = ... }`.
const Table& range_keys();
/// Those of a count, `{ count = ... }`.
const Table& count_keys();

} // namespace tremolo::scene
