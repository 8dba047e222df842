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
    // DOS ended texts with this sign.
    constexpr int end_of_dos_text = 0x1a;
    const char character = c == end_of_dos_text ? ' ' : static_cast<char>(c);
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

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  const auto begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string squeezed(std::string_view text) {
  std::string result;
  for (const char c : trimmed(text))
    if (std::isspace(static_cast<unsigned char>(c)) == 0)
      result.push_back(c);
    else if (result.back() != ' ')
      result.push_back(' ');
  return result;
}

bool says(std::string_view line, std::string_view capitals) {
  return upper(line).find(capitals) != std::string::npos;
}

bool begins(std::string_view line, std::string_view capitals) {
  return upper(line.substr(0, capitals.size())) == capitals;
}

std::optional<std::string_view> after(std::string_view line, std::string_view capitals) {
  const auto at = upper(line).find(capitals);
  if (at == std::string::npos)
    return std::nullopt;
  return line.substr(at + capitals.size());
}

std::optional<Printed> number_after(std::string_view line, std::string_view capitals) {
  const auto rest = after(line, capitals);
  if (!rest)
    return std::nullopt;
  std::string_view text = *rest;
  const auto begin = text.find_first_not_of(" \t:=/");
  if (begin == std::string_view::npos)
    return std::nullopt;
  text.remove_prefix(begin);
  if (text.front() == '(') {
    text.remove_prefix(std::min(text.size(), text.find(')')));
    text.remove_prefix(std::min(text.size(), text.find_first_not_of(" \t:=/)")));
  }
  std::string_view word = text.substr(0, text.find_first_not_of("0123456789+-.eEdD"));
  // The point or the letter that ends a sentence belongs to no number.
  while (!word.empty() && !number(word))
    word.remove_suffix(1);
  if (word.empty())
    return std::nullopt;
  const auto mantissa = word.substr(0, word.find_first_of("eEdD"));
  const auto point = mantissa.find('.');
  const int decimals = point == std::string_view::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
  const auto power = word.substr(std::min(word.size(), mantissa.size() + 1));
  return Printed{*number(word), 0.5 * std::pow(10.0, number(power).value_or(0.0) - decimals)};
}

std::vector<double> fixed_fields(Lines& lines, std::size_t width, std::size_t count) {
  std::vector<double> values;
  while (values.size() < count) {
    if (!lines.next())
      lines.refuse(fmt::format("the file ends after {} of {} numbers", values.size(), count));
    std::string_view rest = lines.text();
    for (; !trimmed(rest).empty(); rest.remove_prefix(std::min(width, rest.size()))) {
      const auto field = trimmed(rest.substr(0, width));
      const auto value = number(field);
      if (!value)
        lines.refuse(fmt::format("'{}' is not a finite number of {} characters", shown(field), width));
      if (values.size() == count)
        lines.refuse(fmt::format("more numbers than the {} that the header announces", count));
      values.push_back(*value);
    }
  }
  return values;
}

std::optional<std::size_t> field_width(std::string_view format) {
  // A count, the letter of the edit, the width, a point: "8F10.3", "1E15.6", "10I8".
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t i = 1; i + 1 < format.size(); ++i) {
    if (std::string_view("FEGIfegi").find(format[i]) == std::string_view::npos || !is_digit(format[i - 1]) ||
        !is_digit(format[i + 1]))
      continue;
    std::size_t width = 0;
    for (std::size_t k = i + 1; k < format.size() && is_digit(format[k]) && width < longest_line; ++k)
      width = 10 * width + static_cast<std::size_t>(format[k] - '0');
    if (width >= 2 && width <= 40)
      return width;
  }
  return std::nullopt;
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
