#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tremolo::soiltest {

/// The position of a name in a list.
/// @throws std::invalid_argument naming all of the list
template <std::size_t N>
std::size_t index_of(const std::array<std::string_view, N>& names, std::string_view text,
                     std::string_view what) {
  for (std::size_t i = 0; i < N; ++i) {
    if (names[i] == text) {
      return i;
    }
  }
  throw std::invalid_argument(fmt::format("\"{}\" is no {}; known: {}", text, what, fmt::join(names, ", ")));
}

} // namespace tremolo::soiltest
