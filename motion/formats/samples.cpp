// Samples in free or fixed columns, as many as a header announces.

#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::motion {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Whether each comma stands in front of a digit, and no number has a point: "0,123 -,045".
bool has_decimal_commas(std::string_view line) {
  bool found = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '.')
      return false;
    if (line[i] != ',')
      continue;
    if (i + 1 == line.size() || !is_digit(line[i + 1]))
      return false;
    found = true;
  }
  return found;
}

/// The numbers of fixed fields that touch: "0.000541-0.000624". Fields of one width have as many decimals
/// each, which shows where one ends.
/// @return false where the word is something else
bool split(std::string_view word, std::vector<double>& values) {
  std::optional<std::size_t> decimals;
  while (!word.empty()) {
    const auto point = word.find('.');
    if (point == std::string_view::npos)
      return false;
    std::size_t end = std::min(word.find_first_not_of("0123456789", point + 1), word.size());
    if (decimals.value_or(end - point) != end - point)
      return false;
    decimals = end - point;
    if (end < word.size() && (word[end] == 'E' || word[end] == 'e'))
      end = std::min(word.find_first_not_of("0123456789", std::min(end + 2, word.size())), word.size());
    const auto value = number(word.substr(0, end));
    if (!value)
      return false;
    values.push_back(*value);
    word.remove_prefix(end);
  }
  return true;
}

} // namespace

void read_samples(Lines& lines, std::size_t count, std::vector<double>& samples) {
  while (lines.next()) {
    if (has_decimal_commas(lines.text()))
      lines.refuse(decimal_commas);
    for (const auto word : words(lines.text())) {
      const auto value = number(word);
      if (value)
        samples.push_back(*value);
      else if (!split(word, samples))
        lines.refuse(fmt::format("'{}' is not a finite number", shown(word)));
      if (samples.size() > count)
        lines.refuse(fmt::format("the header says NPTS = {} but there are more samples", count));
    }
  }
  if (samples.size() != count)
    lines.refuse(fmt::format("the header says NPTS = {} but there are {} samples", count, samples.size()));
}

} // namespace tremolo::motion
