#include "base/text/printable.hpp"

#include <fmt/format.h>

namespace tremolo {

namespace {

constexpr unsigned char delete_character = 0x7f;

/// Bytes of the character of UTF-8 (RFC 3629) that a text begins with; 0 if it begins with none.
std::size_t length_of_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80)
    return 1;
  const std::size_t length = first >= 0xc2 && first < 0xe0   ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  if (length == 0 || text.size() < length)
    return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80)
      return 0;
  const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
  const bool surrogate = first == 0xed && byte(1) >= 0xa0;
  const bool too_large = first == 0xf4 && byte(1) >= 0x90;
  return overlong || surrogate || too_large ? 0 : length;
}

/// Whether a terminal acts on a character instead of showing it: C0, DEL and C1 (ECMA-48).
bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  if (character.size() == 1)
    return (first < 0x20 && first != '\n' && first != '\t') || first == delete_character;
  return character.size() == 2 && first == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0;
}

} // namespace

std::string printable(std::string_view text, std::size_t most) {
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    if (shown.size() >= most)
      return shown + fmt::format(" ... ({} bytes more)", text.size() - at);
    const std::size_t length = length_of_character(text.substr(at));
    const auto character = text.substr(at, length == 0 ? 1 : length);
    if (length != 0 && !is_control(character))
      shown += character;
    else
      for (const char byte : character)
        shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
    at += character.size();
  }
  return shown;
}

std::string printable_line(std::string_view text) {
  std::string line;
  for (const char c : printable(text))
    if (c == '\n')
      line += "\\n";
    else
      line += c;
  return line;
}

bool is_printable_line(std::string_view text) {
  return text.find('\n') == std::string_view::npos && printable(text, std::string_view::npos) == text;
}

} // namespace tremolo
