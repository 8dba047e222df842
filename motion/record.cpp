#include "motion/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

namespace tremolo::motion {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, std::size_t line, const std::string& text) {
  throw RecordError(fmt::format("{}:{}: {}", file.string(), line, text));
}

bool separates(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',' || c == '=' || c == ';';
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

/// A number as Fortran may write it: ".5", "+1.", "1.0D-3".
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

std::string upper(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

struct Header {
  double count = 0.0;
  double dt = 0.0;
};

/// NPTS and DT of a line: each followed by its number, or two numbers followed by the names in the same
/// order.
std::optional<Header> header(std::string_view line) {
  const auto all = words(line);
  std::optional<double> count;
  std::optional<double> dt;
  std::vector<double> leading;
  std::vector<char> order;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string word = upper(all[i]);
    const bool is_count = word == "NPTS" || word == "NPTS.";
    const bool is_dt = word == "DT" || word == "DT.";
    if (is_count || is_dt) {
      order.push_back(is_count ? 'n' : 'd');
      if (i + 1 < all.size())
        if (const auto value = number(all[i + 1]))
          (is_count ? count : dt) = value;
    } else if (const auto value = number(all[i]); value && order.empty()) {
      leading.push_back(*value);
    }
  }
  if (order.size() != 2)
    return std::nullopt;
  if (!count && !dt && leading.size() == 2) {
    count = leading[order[0] == 'n' ? 0 : 1];
    dt = leading[order[0] == 'n' ? 1 : 0];
  }
  if (!count || !dt)
    return std::nullopt;
  return Header{*count, *dt};
}

void check(const Header& header, const std::filesystem::path& file, std::size_t line) {
  constexpr double most_samples = 1e8;
  if (!(header.count >= 2.0 && header.count <= most_samples) || header.count != std::floor(header.count))
    refuse(file, line,
           fmt::format("NPTS = {}, must be a whole number from 2 to {:g}", header.count, most_samples));
  if (!(header.dt > 0.0))
    refuse(file, line, fmt::format("DT = {} s, must be > 0", header.dt));
}

} // namespace

Record parse_record(const std::string& text, const std::filesystem::path& file) {
  std::istringstream stream(text);
  std::string line;
  std::size_t line_number = 0;
  std::optional<Header> found;
  Record record;
  while (std::getline(stream, line)) {
    ++line_number;
    if (!found) {
      found = header(line);
      if (found)
        check(*found, file, line_number);
      continue;
    }
    for (const auto word : words(line)) {
      const auto value = number(word);
      if (!value)
        refuse(file, line_number, fmt::format("'{}' is not a finite number", word.substr(0, 40)));
      record.samples.push_back(*value);
    }
  }
  if (!found)
    refuse(file, std::max<std::size_t>(line_number, 1), "no header line with NPTS and DT");
  if (static_cast<double>(record.samples.size()) != found->count)
    refuse(file, line_number,
           fmt::format("the header says NPTS = {} but there are {} samples", found->count,
                       record.samples.size()));
  record.dt = found->dt;
  return record;
}

Record read_record(const std::filesystem::path& file) {
  std::error_code trouble;
  std::ifstream stream(file, std::ios::binary);
  if (!std::filesystem::exists(file, trouble))
    throw RecordError(fmt::format("{}: there is no such file", file.string()));
  if (!std::filesystem::is_regular_file(file, trouble) || !stream)
    throw RecordError(fmt::format("{}: cannot be read: not a regular file, or no permission", file.string()));
  std::ostringstream text;
  text << stream.rdbuf();
  return parse_record(text.str(), file);
}

std::vector<double> integrate(std::span<const double> samples, double dt) {
  std::vector<double> integral(samples.size(), 0.0);
  for (std::size_t i = 1; i < samples.size(); ++i)
    integral[i] = integral[i - 1] + 0.5 * dt * (samples[i - 1] + samples[i]);
  return integral;
}

} // namespace tremolo::motion
