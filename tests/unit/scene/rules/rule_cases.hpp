#pragma once

// Pieces of text that the tests of the rules share.

#include "../case_text.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene::testing {

inline constexpr std::string_view polygon = "[[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]";

inline constexpr std::string_view layer =
    "[[profile]]\nthickness = 4.0\ndensity = 1700.0\nvs = 80.0\nvp = 150.0\n";

inline std::string with_columns(std::string text = std::string(flat_case)) {
  for (const auto* side : {"left = ", "right = ", "base = "})
    text = with(std::string(side) + "{ model = \"wave\"", std::string(side) + "{ model = \"fe\"", text);
  return text;
}

} // namespace tremolo::scene::testing
