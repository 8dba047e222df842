#include "scene/plan/lining/linings.hpp"

#include "scene/meeting_boxes.hpp"
#include "scene/plan/lining/beam_outline.hpp"
#include "scene/plan/structures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::scene {

namespace {

double explicit_step(const mpm_domain::BeamSection& section, double length) {
  const double shearing = 12.0 * section.bending / (section.shear * length * length);
  return length * std::min(std::sqrt(section.mass / section.axial),
                           std::sqrt(section.rotary * (1.0 + shearing) / (3.0 * section.bending)));
}

/// Sum of tan(turn/2) over the corners of a polygon: moved inward by t/2, its edges are t times this shorter.
double half_turns(const Polygon& corners) {
  const std::size_t n = corners.size();
  double sum = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const Point& at = corners[k];
    const Point in{at.x - corners[(k + n - 1) % n].x, at.y - corners[(k + n - 1) % n].y};
    const Point out{corners[(k + 1) % n].x - at.x, corners[(k + 1) % n].y - at.y};
    sum += std::tan(0.5 * std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y));
  }
  return sum;
}

PlannedRing plan_ring(const Case& scene, const Lining& lining, double outer_radius) {
  const auto& section = lining.section;
  const double radius = outer_radius - 0.5 * lining.thickness;
  PlannedRing ring{.period = 2.0 * std::numbers::pi * radius * radius *
                             std::sqrt(section.mass / (7.2 * section.bending)),
                   .soil = {}};
  const Box box = box_of(lining.outline.corners);
  const double y = 0.5 * (box.y_min + box.y_max);
  const Point beside{box.x_max + 0.5 * contact_cell_size(scene), y};
  for (const Region& region : scene.regions)
    if (contains(region.polygon, beside)) { // the later one wins
      const Soil& soil = scene.soils[region.soil_at(y)];
      const auto elastic = materials::elasticity(soil.law);
      ring.flexibility = elastic.young / (2.0 * (1.0 + elastic.poisson)) * radius * radius * radius /
                         (3.0 * section.bending);
      ring.soil = soil.name;
    }
  return ring;
}

std::string section_text(const Lining& lining) {
  const auto& section = lining.section;
  const std::string shear =
      std::isfinite(section.shear) ? fmt::format("GA {:.4g} N/m", section.shear) : "no shearing";
  return fmt::format("EA {:.4g} N/m, EI {:.4g} N m, {}, {:.4g} kg/m2", section.axial, section.bending, shear,
                     section.mass);
}

std::string surface_text(const Case& scene, const Lining& lining) {
  std::string text;
  for (std::size_t s = 0; s < scene.soils.size(); ++s) {
    const auto& [friction, adhesion] = lining.against[s];
    text += fmt::format("{}'{}' friction {:g}", text.empty() ? "" : ", ", scene.soils[s].name, friction);
    if (adhesion > 0.0)
      text += fmt::format(" and adhesion {:g} Pa", adhesion);
  }
  return text;
}

} // namespace

std::vector<PlannedLining> plan_linings(const Case& scene) {
  std::vector<PlannedLining> all;
  const double h = contact_cell_size(scene);
  for (const Lining& lining : scene.linings) {
    const BeamOutline outline = beam_outline(lining, h);
    const double around = perimeter(outline.corners);
    PlannedLining& planned = all.emplace_back();
    planned.name = lining.name;
    planned.elements = outline.corners.size();
    planned.hinges = outline.hinges.size();
    planned.axis = around - lining.thickness * half_turns(outline.corners);
    planned.mass = lining.section.mass * planned.axis;
    planned.segments = around / h;
    double shortest = around;
    for (std::size_t k = 0; k < outline.corners.size(); ++k) {
      const Point a = outline.corners[k];
      const Point b = outline.corners[(k + 1) % outline.corners.size()];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      planned.longest = std::max(planned.longest, length);
      shortest = std::min(shortest, length);
    }
    planned.explicit_step = explicit_step(lining.section, shortest * planned.axis / around);
    if (lining.outline.key == "circle")
      planned.ring = plan_ring(scene, lining, std::sqrt(area(lining.outline.corners) / std::numbers::pi));
  }
  return all;
}

std::string linings_effect_text(std::span<const PlannedLining> linings) {
  if (linings.empty())
    return "no [[lining]]";
  std::string text;
  double segments = 0.0;
  for (const PlannedLining& lining : linings) {
    text += fmt::format("'{}' {:.6g} kg/m, {} beam elements; ", lining.name, lining.mass, lining.elements);
    segments += lining.segments;
  }
  return text + fmt::format("about {:.0f} contact segments (about {:.0f} us a step)", segments,
                            segments * lining_segment_cost_ns / 1e3);
}

std::string linings_text(const Case& scene, std::span<const PlannedLining> linings, double dt) {
  const double h = contact_cell_size(scene);
  std::string text;
  for (std::size_t i = 0; i < linings.size(); ++i) {
    const PlannedLining& planned = linings[i];
    const Lining& lining = scene.linings[i];
    text += fmt::format(
        "  {:<18}{:g} m thick around an axis of {:.4g} m: {:.6g} kg/m, {} elements of {:.3g} m at "
        "most, {} hinge{}\n"
        "    section    {}\n"
        "    surface    {}; about {:.0f} segments of one cell, {:g} m\n",
        planned.name, lining.thickness, planned.axis, planned.mass, planned.elements, planned.longest,
        planned.hinges, planned.hinges == 1 ? "" : "s", section_text(lining), surface_text(scene, lining),
        planned.segments, h);
    if (planned.ring)
      text += fmt::format(
          "    ring       ovals freely with a period of {:.3g} s; flexibility ratio G R3/(3 EI) = "
          "{:.3g} in soil '{}'\n",
          planned.ring->period, planned.ring->flexibility, planned.ring->soil);
    text +=
        fmt::format("    step       bending is marched implicitly and does not set it: explicit elements "
                    "would need {:.2g} s, the domain takes {:.2g} s; it damps motion at f Hz by the ratio "
                    "{:.2g} f\n",
                    planned.explicit_step, dt, std::numbers::pi * dt);
  }
  return text;
}

} // namespace tremolo::scene
