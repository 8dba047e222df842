#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace tremolo::testing {

/// Pieces of a file, one behind the other.
inline std::string join(std::initializer_list<std::string_view> pieces) {
  std::string text;
  for (const std::string_view piece : pieces)
    text.append(piece);
  return text;
}

} // namespace tremolo::testing
