#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// Description of a soil's table.
inline constexpr std::string_view soil_meaning =
    "A soil: the keys of its model, or the name of one in the library, or both. Elastic constants, of models "
    "that "
    "have them, are either `young` and `poisson`, or `vs` and `vp`.";

/// The keys of a soil, the same in cases, soil tests and the library.
std::vector<Key> soil_keys();

} // namespace tremolo::scene
