#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>

namespace tremolo::scene {

namespace {

bool in_soil(const Case& scene, Point p) {
  return std::ranges::any_of(scene.regions,
                             [p](const Region& region) { return contains(region.polygon, p); });
}

/// Whether a name can be that of a file and of a group in HDF5. Bytes beyond ASCII are letters of UTF-8.
bool is_plain(const std::string& name) {
  const auto letter = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
  };
  return letter(name.front()) && std::ranges::all_of(name, [&](char c) {
           return letter(c) || c == '_' || c == '-' || c == '+' || c == '.' || c == ' ';
         });
}

} // namespace

void monitors_lie_in_soil(const Case& scene, Findings& findings) {
  const bool regions_known =
      std::ranges::none_of(scene.regions, [](const Region& r) { return r.polygon.empty(); });
  for (std::size_t i = 0; i < scene.monitors.size(); ++i) {
    const auto& [name, point] = scene.monitors[i];
    const std::string path = fmt::format("monitor[{}]", i);
    if (!name.empty() && !is_plain(name))
      findings.add(
          path + ".name",
          fmt::format(
              "'name' = \"{}\" names a table in the results and a picture: letters, digits, blanks and "
              "_ - + . are allowed, beginning with a letter or digit",
              name));
    const auto first = std::ranges::find(scene.monitors, name, &Monitor::name) - scene.monitors.begin();
    if (!name.empty() && first < static_cast<std::ptrdiff_t>(i))
      findings.add(path + ".name", fmt::format("'name' = \"{}\" is taken by the monitor in line {}", name,
                                               findings.place(fmt::format("monitor[{}].name", first)).line));
    if (regions_known && findings.sound("region") && findings.sound(path + ".point") &&
        !in_soil(scene, point))
      findings.add(path + ".point", fmt::format("'point' [{}, {}] lies in no region", point.x, point.y));
  }
}

} // namespace tremolo::scene
