#pragma once

#include "scene/case.hpp"

#include <array>
#include <string_view>

namespace tremolo::scene {

/// The value of an enumeration that has this name in case files; the first one for a name that is none (which
/// the key table has refused before).
template <class Enum, std::size_t N>
Enum from_name(std::string_view text, const std::array<Enum, N>& values) {
  for (const Enum value : values)
    if (name(value) == text)
      return value;
  return values.front();
}

} // namespace tremolo::scene
