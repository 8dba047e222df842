#pragma once

// The flat case under gravity, with a ring in it.

#include "structure_case.hpp"

#include <string>

namespace tremolo::scene::testing {

/// The ring begins in line 33: 0.2 m of concrete around 4 m.
inline std::string with_ring() {
  return heavy() + "[[lining]]\nname = \"ring\"\ncircle = { centre = [10.0, -5.0], radius = 2.1 }\n"
                   "thickness = 0.2\nyoung = 30e9\npoisson = 0.2\ndensity = 2500.0\nfriction = 0.5\n";
}

/// The ring with a piece of its text replaced.
inline std::string ring_with(std::string_view old, std::string_view replacement) {
  return with(old, replacement, with_ring());
}

} // namespace tremolo::scene::testing
