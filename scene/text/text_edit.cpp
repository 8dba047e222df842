#include "scene/text/text_edit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

std::size_t offset(std::string_view text, toml::source_position position) {
  std::size_t at = 0;
  for (toml::source_index line = 1; line < position.line; ++line)
    at = text.find('\n', at) + 1;
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  for (toml::source_index column = 1; column < position.column && at < text.size(); ++column)
    do {
      ++at;
    } while (at < text.size() && continues(text[at]));
  return at;
}

Replacement without_pair(std::string_view text, std::size_t key, std::size_t value_end) {
  constexpr std::string_view blank = " \t\r";
  const auto past_blanks = [&](std::size_t at) {
    return std::min(text.find_first_not_of(blank, at), text.size());
  };
  const auto before = text.find_last_of(",{\n", key); // a dotted key may begin before its last part
  if (before != std::string_view::npos && text[before] == ',')
    return {before, value_end, ""};
  const auto begin = before == std::string_view::npos ? 0 : before + 1;
  auto end = past_blanks(value_end);
  if (before != std::string_view::npos && text[before] == '{')
    return {past_blanks(begin), end < text.size() && text[end] == ',' ? past_blanks(end + 1) : value_end, ""};
  if (end < text.size() && text[end] == '\n')
    ++end;
  return {begin, end, ""};
}

std::string separator_after(std::string_view text, std::size_t key) {
  const auto line = text.find_last_of(",{\n", key == 0 ? 0 : key - 1);
  const auto first = text.find_first_not_of(" \t\r,{\n", line == std::string_view::npos ? 0 : line);
  const bool in_line = line != std::string_view::npos && text[line] != '\n';
  return fmt::format("{}{}", in_line ? ", " : "\n", text.substr(first, key - first));
}

} // namespace tremolo::scene
