#include "scene/plan/section/section_cuts.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::scene {

namespace {

std::string fault(Crossing crossing, const std::string& structure) {
  switch (crossing) {
  case Crossing::never:
    return fmt::format("does not go through structure '{}': move its ends", structure);
  case Crossing::ends_within:
    return fmt::format("ends within structure '{}', must go from one surface to the other: move its ends out "
                       "of it",
                       structure);
  case Crossing::repeatedly:
    return fmt::format("goes through structure '{}' more than once: give each part a [[section]] of its own",
                       structure);
  case Crossing::once:
    break;
  }
  return {};
}

} // namespace

void sections_go_through(const Case& scene, Findings& findings) {
  for (const Section& section : scene.sections) {
    if (!has_lines(scene, section, findings))
      continue;
    const Structure& structure = scene.structures[*section.structure];
    for (const Section::Line& line : section.lines) {
      if (!(std::hypot(line.to.x - line.from.x, line.to.y - line.from.y) > 0.0)) {
        findings.add(line_path(section),
                     fmt::format("'from' and 'to' are the point [{:g}, {:g}], must be apart", line.from.x,
                                 line.from.y));
        break;
      }
      const Crossing crossing = cut_of(structure, line).crossing;
      if (crossing != Crossing::once) {
        findings.add(line_path(section),
                     fmt::format("the line from [{:.4g}, {:.4g}] to [{:.4g}, {:.4g}] {}", line.from.x,
                                 line.from.y, line.to.x, line.to.y, fault(crossing, structure.name)));
        break;
      }
    }
  }
}

} // namespace tremolo::scene
