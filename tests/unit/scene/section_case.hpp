#pragma once

// The block of the flat case, elastic and cut.

#include "structure_case.hpp"

#include <string>
#include <string_view>

namespace tremolo::scene::testing {

inline std::string elastic_block() {
  return with("rigid = true", "young = 20e6\npoisson = 0.2", with_block());
}

/// The section begins in line 40 and cuts the block.
inline std::string with_section(std::string_view keys) {
  return elastic_block() + "[[section]]\nname = \"foot\"\nstructure = \"block\"\n" + std::string(keys) + "\n";
}

/// A section through the block with a piece of its text replaced.
inline std::string section_with(std::string_view old, std::string_view replacement) {
  return with(old, replacement, with_section("from = [8.0, 1.0]\nto = [12.0, 1.0]"));
}

/// A block with a hole of 4 m, whose walls are 2 m thick, and a section.
inline std::string with_hole(std::string_view keys) {
  return with("polygon = [[8.0, 0.0], [12.0, 0.0], [12.0, 4.0], [8.0, 4.0]]",
              "polygon = [[6.0, 0.0], [14.0, 0.0], [14.0, 8.0], [6.0, 8.0]]\n"
              "hole = [[8.0, 2.0], [12.0, 2.0], [12.0, 6.0], [8.0, 6.0]]",
              with_section(keys));
}

} // namespace tremolo::scene::testing
