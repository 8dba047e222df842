#include "scene/plan/structures.hpp"

#include "mesh/cell_size.hpp"
#include "mesh/polygon_measures.hpp"
#include "mpm_domain/spec/structure.hpp"
#include "scene/meeting_boxes.hpp"
#include "scene/plan/levels.hpp"
#include "scene/plan/step/step_limit.hpp"
#include "scene/soils/water_table.hpp"
#include "scene/thickness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tremolo::scene {

namespace {

// Memory per contact node (its state, a copy, sums over particles) and per node of a window two cells wider
// than the body (sums, the body's surface).
constexpr double bytes_of_contact_node = 850.0;
constexpr double bytes_of_window_node = 112.0;
constexpr double window_margin = 5.0; // nodes of the window beyond the body's own cells

bool in_soil_outside(const Case& scene, const std::vector<Polygon>& structures, Point p) {
  return std::ranges::any_of(scene.regions,
                             [p](const Region& region) { return contains(region.polygon, p); }) &&
         std::ranges::none_of(structures, [p](const Polygon& outline) { return contains(outline, p); });
}

/// Calls act(middle, length) for pieces of a structure's outline, a quarter of a cell long at most, that have
/// soil next to them. Soil closer than the contact's opening gap counts as touching at the start.
template <class Act>
void for_pieces_on_soil(const Case& scene, std::size_t structure, const Act& act) {
  const double h = contact_cell_size(scene);
  const std::vector<Polygon> all = outlines(scene);
  const Polygon& outline = scene.structures[structure].outline.corners;
  const double outward = mesh::signed_double_area(outline) > 0.0 ? 1.0 : -1.0;
  const double gap = mpm_domain::ContactGaps{}.opening * h;
  for_pieces(outline, scene.mesh.box.y_max + gap, 0.25 * h, [&](Point from, Point to) {
    const Point middle{0.5 * (from.x + to.x), 0.5 * (from.y + to.y)};
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const double off = length > 0.0 ? outward * gap / length : 0.0;
    if (in_soil_outside(scene, all, {middle.x + off * (to.y - from.y), middle.y - off * (to.x - from.x)}))
      act(middle, length);
  });
}

/// Nodes of the contact cells that have enough of a structure's surface on soil.
std::size_t contact_nodes(const Case& scene, std::size_t structure) {
  const double h = contact_cell_size(scene);
  std::map<std::pair<long, long>, double> shares; // of the surface, in cells
  for_pieces_on_soil(scene, structure, [&](Point middle, double length) {
    const double x = (middle.x - scene.mesh.box.x_min) / h;
    const double y = (middle.y - scene.mesh.box.y_min) / h;
    for (const double i : {std::floor(x), std::floor(x) + 1.0})
      for (const double j : {std::floor(y), std::floor(y) + 1.0})
        shares[{std::lround(i), std::lround(j)}] +=
            length / h * (1.0 - std::abs(x - i)) * (1.0 - std::abs(y - j));
  });
  return static_cast<std::size_t>(std::ranges::count_if(
      shares, [](const auto& node) { return node.second > mpm_domain::least_wall_share; }));
}

/// "57.8 kN/m, net 135 kN/m upwards in water"
std::string weight_text(const PlannedStructure& structure) {
  std::string text = fmt::format("{:.4g} kN/m", structure.weight / 1e3);
  const double net = (structure.weight - structure.buoyancy) / 1e3;
  if (structure.buoyancy > 0.0)
    text += fmt::format(", net {:.4g} kN/m {} in water", std::abs(net), net < 0.0 ? "upwards" : "downwards");
  return text;
}

std::string kind_text(const Structure& structure) {
  return structure.stiffness ? fmt::format("elastic, young {:g} Pa, poisson {:g}", structure.stiffness->young,
                                           structure.stiffness->poisson)
                             : "rigid";
}

std::string surface_text(const Case& scene, const Structure& structure) {
  std::string text;
  for (std::size_t s = 0; s < scene.soils.size(); ++s) {
    const auto& [friction, adhesion] = structure.against[s];
    text += fmt::format("{}'{}' friction {:g}", text.empty() ? "" : ", ", scene.soils[s].name, friction);
    if (adhesion > 0.0)
      text += fmt::format(" and adhesion {:g} Pa", adhesion);
  }
  return text;
}

} // namespace

std::vector<Polygon> outlines(const Case& scene) {
  std::vector<Polygon> all;
  for (const Structure& structure : scene.structures)
    if (!structure.outline.corners.empty())
      all.push_back(structure.outline.corners);
  for (const Lining& lining : scene.linings)
    if (!lining.outline.corners.empty())
      all.push_back(lining.outline.corners);
  return all;
}

std::vector<Polygon> region_polygons(const Case& scene) {
  std::vector<Polygon> polygons;
  for (const Region& region : scene.regions)
    polygons.push_back(region.polygon);
  return polygons;
}

double contact_cell_size(const Case& scene) {
  int finest = 0;
  for (const Refinement& refine : scene.mesh.refine)
    finest = std::max(finest, refine.level);
  return mesh::cell_size(scene.mesh.size, finest);
}

std::vector<Point> points_on_soil(const Case& scene, std::size_t structure) {
  std::vector<Point> points;
  for_pieces_on_soil(scene, structure, [&](Point middle, double) { points.push_back(middle); });
  return points;
}

std::vector<PlannedStructure> plan_structures(const Case& scene) {
  std::vector<PlannedStructure> all;
  for (std::size_t i = 0; i < scene.structures.size(); ++i) {
    const Structure& structure = scene.structures[i];
    const Polygon& outline = structure.outline.corners;
    const double solid = area(outline) - (structure.hole ? area(structure.hole->corners) : 0.0);
    PlannedStructure& planned = all.emplace_back();
    planned = {.name = structure.name, .area = solid, .mass = structure.density * solid};
    planned.weight = planned.mass * scene.gravity->acceleration;
    const Box around = box_of(outline);
    const double middle = 0.5 * (around.x_min + around.x_max);
    if (scene.water)
      planned.buoyancy = mesh::measures(mesh::part_below(outline, table_at(scene, middle))).area *
                         scene.water->fluid.density * scene.gravity->acceleration;
    planned.contact_nodes = static_cast<double>(contact_nodes(scene, i));
    const double h = contact_cell_size(scene);
    const double height = std::min(around.y_max, scene.mesh.box.y_max) - around.y_min;
    planned.bytes = bytes_of_contact_node * planned.contact_nodes +
                    bytes_of_window_node * (around.width() / h + window_margin) *
                        (std::max(0.0, height) / h + window_margin);
  }
  return all;
}

std::string contact_text(std::span<const PlannedStructure> structures) {
  if (structures.empty())
    return "no [[structure]]";
  std::string text = fmt::format("{} structure{}: ", structures.size(), structures.size() == 1 ? "" : "s");
  double nodes = 0.0;
  double bytes = 0.0;
  for (const PlannedStructure& structure : structures) {
    text += fmt::format("'{}' {:.6g} kg/m, {}; ", structure.name, structure.mass, weight_text(structure));
    nodes += structure.contact_nodes;
    bytes += structure.bytes;
  }
  return text +
         fmt::format("about {:.0f} contact nodes ({:.0f} kB, about {:.0f} us a step); soil elsewhere pays "
                     "nothing",
                     nodes, bytes / 1e3, nodes * contact_node_cost_ns / 1e3);
}

namespace {

/// What replacing an elastic ring by a lining would save; empty if the ring's walls are too thick to be
/// beams.
/// @param thin  the smallest wall thickness, m
std::string lining_text(const Case& scene, std::size_t structure, double thin) {
  const Structure& ring = scene.structures[structure];
  const Box around = box_of(ring.outline.corners);
  constexpr double thickest_beam = 0.2; // of the width
  if (!ring.stiffness || !ring.hole ||
      thin > thickest_beam * std::min(around.width(), around.y_max - around.y_min))
    return "";
  Case without = scene;
  without.structures[structure].stiffness.reset();
  const double h = contact_cell_size(scene);
  constexpr double cells_that_bend = 4.0;
  const double small = std::min(h, thin / cells_that_bend);
  return fmt::format(
      "    lining     a [[lining]] in its place bends on these cells with a critical step of {:.3g} s; "
      "solid, it bends on cells of {:.3g} m, with {:.3g} s\n",
      critical_time_step(without, levels(without)), small, critical_step(ring, small));
}

} // namespace

std::string structures_text(const Case& scene, std::span<const PlannedStructure> structures) {
  const double h = contact_cell_size(scene);
  std::string text;
  for (std::size_t i = 0; i < structures.size(); ++i) {
    const PlannedStructure& planned = structures[i];
    const auto& hole = scene.structures[i].hole;
    const double thin = thickness(scene.structures[i].outline.corners, hole ? hole->corners : Polygon{});
    text +=
        fmt::format("  {:<18}{}, {:.4g} m2 of {:g} kg/m3: {:.6g} kg/m, {}; about {:.0f} contact nodes\n"
                    "    thickness  {:.3g} m at the thinnest place, {:.3g} cells of {:g} m\n"
                    "    surface    {}\n{}",
                    planned.name, kind_text(scene.structures[i]), planned.area, scene.structures[i].density,
                    planned.mass, weight_text(planned), planned.contact_nodes, thin, thin / h, h,
                    surface_text(scene, scene.structures[i]), lining_text(scene, i, thin));
  }
  return text;
}

} // namespace tremolo::scene
