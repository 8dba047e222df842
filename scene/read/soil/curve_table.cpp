#include "scene/read/soil/curve_table.hpp"

#include "base/text/unreadable.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tremolo::scene {

namespace {

constexpr std::string_view header = "strain,modulus_reduction,damping";
constexpr std::size_t longest_line = 4096;
constexpr std::size_t most_rows = 10000;

[[noreturn]] void refuse(const std::filesystem::path& file, std::size_t line, const std::string& why) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", file.string(), line, why));
}

/// Three numbers, separated by commas.
std::array<double, 3> row(std::string_view text, const std::filesystem::path& file, std::size_t line) {
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto comma = text.find(',');
    auto cell = text.substr(0, comma);
    while (!cell.empty() && cell.front() == ' ')
      cell.remove_prefix(1);
    while (!cell.empty() && cell.back() == ' ')
      cell.remove_suffix(1);
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), values[i]);
    if (error != std::errc{} || end != cell.data() + cell.size() ||
        (comma == std::string_view::npos) != (i == 2))
      refuse(file, line, fmt::format("expected three numbers '{}'", header));
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  return values;
}

} // namespace

materials::SoilCurves read_curve_table(const std::filesystem::path& file) {
  if (const auto why = why_unreadable(file); !why.empty())
    throw std::invalid_argument(fmt::format("{}: {}", file.string(), why));
  std::ifstream stream(file);
  materials::SoilCurves curves;
  bool begun = false;
  std::size_t number = 0;
  for (std::string line(longest_line, '\0'); stream.getline(line.data(), longest_line);) {
    ++number;
    std::string_view text(line.c_str());
    if (!text.empty() && text.back() == '\r')
      text.remove_suffix(1);
    if (text.empty() || text.front() == '#')
      continue;
    if (!begun) {
      if (text != header)
        refuse(file, number, fmt::format("expected the header '{}'", header));
      begun = true;
      continue;
    }
    const auto [strain, modulus, damping] = row(text, file, number);
    curves.strain.push_back(strain);
    curves.modulus_ratio.push_back(modulus);
    curves.damping_ratio.push_back(damping);
    if (curves.strain.size() > most_rows)
      refuse(file, number, fmt::format("more than {} rows", most_rows));
  }
  if (!stream.eof())
    refuse(file, number + 1, fmt::format("a line of more than {} characters", longest_line));
  try {
    materials::validate(curves);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", file.string(), error.what()));
  }
  return curves;
}

} // namespace tremolo::scene
