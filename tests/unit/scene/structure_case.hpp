#pragma once

// The flat case under gravity, and with a block on it.

#include "case_text.hpp"

#include <string>

namespace tremolo::scene::testing {

/// 32 lines.
inline std::string heavy() {
  return with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]");
}

/// The block begins in line 33.
inline std::string with_block() {
  return heavy() + "[[structure]]\nname = \"block\"\npolygon = [[8.0, 0.0], [12.0, 0.0], [12.0, 4.0], [8.0, "
                   "4.0]]\ndensity = 1000.0\nrigid = true\nfriction = 0.5\n";
}

} // namespace tremolo::scene::testing
