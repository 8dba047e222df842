#pragma once

// The block of the flat case with an anchor.

#include "structure_case.hpp"

#include <string>
#include <string_view>

namespace tremolo::scene::testing {

/// The prop begins in line 39.
inline std::string with_prop(std::string_view keys = "from = { structure = \"block\", at = [8.0, 2.0] }\n"
                                                     "to = { at = [4.0, -3.0] }\nstiffness = 2e6") {
  return with_block() + "[[prop]]\nname = \"anchor\"\n" + std::string(keys) + "\n";
}

inline std::string prop_with(std::string_view old, std::string_view replacement) {
  return with(old, replacement, with_prop());
}

} // namespace tremolo::scene::testing
