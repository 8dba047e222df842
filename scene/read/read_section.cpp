#include "scene/read/read.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tremolo::scene {

namespace {

/// The lines of a ring from inside outwards, counter-clockwise from the direction of x.
std::vector<Section::Line> lines_of(const TableReader& ring, Findings& findings) {
  const double inner = ring.number("inner");
  const double outer = ring.number("outer");
  if (findings.sound(ring.path("inner")) && findings.sound(ring.path("outer")) && !(inner < outer)) {
    findings.add(
        ring.path("inner"),
        fmt::format("'inner' = {:g} m is out of range, must be below 'outer' = {:g} m", inner, outer));
    return {};
  }
  const Point centre = ring.point("centre");
  const int count = ring.integer("count");
  std::vector<Section::Line> lines;
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    const Point out{std::cos(angle), std::sin(angle)};
    lines.push_back({{centre.x + inner * out.x, centre.y + inner * out.y},
                     {centre.x + outer * out.x, centre.y + outer * out.y}});
  }
  return lines;
}

Section read_section(const TableReader& table, const std::vector<Structure>& structures, Findings& findings) {
  Section section{.name = table.text("name"),
                  .structure = structure_index(table, structures, findings),
                  .lines = {},
                  .centre = {},
                  .path = table.path()};
  const bool straight = table.given("from") || table.given("to");
  if (const auto ring = table.table("ring")) {
    if (straight)
      findings.add(table.path(table.given("from") ? "from" : "to"),
                   "'from' and 'to' exclude 'ring': remove one or the other");
    section.lines = lines_of(*ring, findings);
    section.centre = ring->point("centre");
  } else if (!straight) {
    if (findings.sound(table.path()))
      findings.add(table.path("from"), "missing 'from' and 'to' of a cut, or 'ring'");
  } else if (complete(table, findings, "from", "to")) {
    section.lines = {{table.point("from"), table.point("to")}};
  }
  return section;
}

} // namespace

void read_sections(Document& document, Findings& findings, Case& scene) {
  for (const auto& table : document.array("section"))
    scene.sections.push_back(read_section(table, scene.structures, findings));
}

} // namespace tremolo::scene
