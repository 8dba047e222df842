#include "scene/plan/section/section_cuts.hpp"

#include "scene/plan/structures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tremolo::scene {

namespace {

Point at(const Section::Line& line, double share) {
  return {line.from.x + share * (line.to.x - line.from.x), line.from.y + share * (line.to.y - line.from.y)};
}

/// Adds where the line meets the edges of a polygon, as shares of the way along it.
void add_meetings(const Polygon& polygon, const Section::Line& line, std::vector<double>& shares) {
  const Point way{line.to.x - line.from.x, line.to.y - line.from.y};
  const auto aside = [&](Point p) { return way.x * (p.y - line.from.y) - way.y * (p.x - line.from.x); };
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const double a = aside(polygon[j]);
    const double b = aside(polygon[i]);
    if ((a > 0.0) == (b > 0.0))
      continue;
    const double on_edge = a / (a - b);
    const Point p{polygon[j].x + on_edge * (polygon[i].x - polygon[j].x),
                  polygon[j].y + on_edge * (polygon[i].y - polygon[j].y)};
    shares.push_back(((p.x - line.from.x) * way.x + (p.y - line.from.y) * way.y) /
                     (way.x * way.x + way.y * way.y));
  }
}

/// A part of the line, as shares of the way along it.
struct Part {
  double begin, end;
};

bool is_solid(const Structure& structure, Point p) {
  return contains(structure.outline.corners, p) &&
         !(structure.hole && strictly_inside(structure.hole->corners, p));
}

/// Parts of the line within the structure; what lies beyond its ends counts as far as a surface.
std::vector<Part> parts_within(const Structure& structure, const Section::Line& line) {
  std::vector<double> shares;
  add_meetings(structure.outline.corners, line, shares);
  if (structure.hole)
    add_meetings(structure.hole->corners, line, shares);
  std::ranges::sort(shares);
  std::vector<Part> parts;
  constexpr double on_surface = 1e-9; // two surfaces meet, or an end lies on one
  for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
    const Part part{shares[k], shares[k + 1]};
    if (part.end - part.begin < on_surface || part.end < on_surface || part.begin > 1.0 - on_surface ||
        !is_solid(structure, at(line, 0.5 * (part.begin + part.end))))
      continue;
    if (!parts.empty() && part.begin - parts.back().end < on_surface)
      parts.back().end = part.end;
    else
      parts.push_back(part);
  }
  return parts;
}

} // namespace

double SectionCut::thickness() const {
  return std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
}

SectionCut cut_of(const Structure& structure, const Section::Line& line) {
  const std::vector<Part> parts = parts_within(structure, line);
  if (parts.empty())
    return {};
  const auto& [begin, end] = Part{parts.front().begin, parts.back().end};
  // A share of the line's length at either end: the outline of a circle is a polygon, whose corners stand
  // out.
  constexpr double near_surface = 0.02;
  SectionCut cut{Crossing::once, {at(line, begin), at(line, end)}};
  if (parts.size() > 1)
    cut.crossing = Crossing::repeatedly;
  else if (begin < -near_surface || end > 1.0 + near_surface)
    cut.crossing = Crossing::ends_within;
  return cut;
}

std::vector<SectionCut> cuts_of(const Case& scene, const Section& section) {
  std::vector<SectionCut> cuts;
  for (const Section::Line& line : section.lines)
    cuts.push_back(cut_of(scene.structures[*section.structure], line));
  return cuts;
}

std::string line_path(const Section& section) {
  return section.path + (section.centre ? ".ring" : ".from");
}

bool has_lines(const Case& scene, const Section& section, const Findings& findings) {
  if (!section.structure || section.lines.empty())
    return false;
  const auto sound = [&](const char* key) { return findings.sound(section.path + key); };
  const Structure& structure = scene.structures[*section.structure];
  return sound(".from") && sound(".to") && sound(".ring") && sound(".ring.centre") && sound(".ring.inner") &&
         sound(".ring.outer") && sound(".ring.count") &&
         findings.sound(structure.path + "." + std::string(structure.outline.key)) &&
         structure.outline.corners.size() > 2;
}

std::string sections_text(const Case& scene) {
  const double h = contact_cell_size(scene);
  std::string text;
  for (const Section& section : scene.sections) {
    const std::vector<SectionCut> cuts = cuts_of(scene, section);
    const double thinnest =
        std::ranges::min(cuts, {}, [](const SectionCut& cut) { return cut.thickness(); }).thickness();
    text += fmt::format("  {:<18}{} through '{}', {:.3g} m{}, {:.3g} cells of {:g} m\n", section.name,
                        section.centre ? fmt::format("ring of {} cuts", cuts.size()) : "cut",
                        scene.structures[*section.structure].name, thinnest,
                        section.centre ? " at the thinnest place" : "", thinnest / h, h);
  }
  return text;
}

} // namespace tremolo::scene
