#include "motion/read/text.hpp"

#include "motion/read/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace tremolo::motion {

namespace {

bool separates(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',' || c == '=' || c == ';';
}

bool is_binary(char c) {
  return std::iscntrl(static_cast<unsigned char>(c)) != 0 && std::isspace(static_cast<unsigned char>(c)) == 0;
}

} // namespace

void refuse(const std::filesystem::path& file, std::size_t line, const std::string& text) {
  throw RecordError(fmt::format("{}:{}: {}", file.string(), std::max<std::size_t>(line, 1), text));
}

bool Lines::next() {
  text_.clear();
  std::streambuf& buffer = *stream_.rdbuf();
  constexpr int end = std::istream::traits_type::eof();
  if (buffer.sgetc() == end)
    return false;
  ++number_;
  for (int c = buffer.sbumpc(); c != end && c != '\n'; c = buffer.sbumpc()) {
    const char character = static_cast<char>(c);
    if (is_binary(character))
      refuse("binary data, not text");
    if (text_.size() == longest_line)
      refuse(fmt::format("a line of more than {} characters", longest_line));
    text_.push_back(character);
  }
  return true;
}

void Lines::refuse(const std::string& text) const {
  motion::refuse(file_, number_, text);
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> found;
  for (std::size_t i = 0; i < line.size();) {
    if (separates(line[i])) {
      ++i;
      continue;
    }
    const std::size_t begin = i;
    while (i < line.size() && !separates(line[i]))
      ++i;
    found.push_back(line.substr(begin, i - begin));
  }
  return found;
}

std::optional<double> number(std::string_view word) {
  std::string text(word.starts_with('+') ? word.substr(1) : word);
  std::ranges::replace_if(
      text, [](char c) { return c == 'D' || c == 'd'; }, 'E');
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::string shown(std::string_view text) {
  std::string result(text.substr(0, 40));
  std::ranges::replace_if(
      result, [](char c) { return std::isprint(static_cast<unsigned char>(c)) == 0; }, '?');
  return result;
}

std::string upper(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

} // namespace tremolo::motion
