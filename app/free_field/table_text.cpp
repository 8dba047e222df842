#include "app/free_field/table_text.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace tremolo::app {

namespace {

constexpr std::string_view blanks = " \t\r";

} // namespace

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto at = text.find(separator);
    parts.push_back(trimmed(text.substr(0, at)));
    if (at == std::string_view::npos)
      return parts;
    text.remove_prefix(at + 1);
  }
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> parts;
  for (text = trimmed(text); !text.empty();) {
    const auto end = text.find_first_of(blanks);
    parts.push_back(text.substr(0, end));
    text = end == std::string_view::npos ? "" : trimmed(text.substr(end));
  }
  return parts;
}

std::optional<double> finite_number(std::string_view text) {
  if (text.starts_with('+'))
    text.remove_prefix(1);
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, trouble] = std::from_chars(text.data(), end, value);
  if (trouble != std::errc{} || stop != end || !std::isfinite(value))
    return std::nullopt;
  return value;
}

} // namespace tremolo::app
