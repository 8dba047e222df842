#pragma once

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tremolo::app {

/// The value that an option names; empty if the option was not given.
/// @param named  the value of a word, nothing if there is none
/// @throws std::invalid_argument for a word that is not known
template <class Enum>
std::optional<Enum> chosen(const std::string& text, std::optional<Enum> (*named)(std::string_view),
                           const char* option) {
  if (text.empty())
    return std::nullopt;
  const auto value = named(text);
  if (!value)
    throw std::invalid_argument(fmt::format("{} '{}' is not known", option, text));
  return value;
}

} // namespace tremolo::app
