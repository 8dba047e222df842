#include "mpm_domain/head/ground_mesh.hpp"

#include "mesh/cell_size.hpp"
#include "mesh/polygon.hpp"
#include "mpm_domain/spec/slices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

constexpr double most_nodes = 15000; ///< of a flow that is found in seconds
constexpr double tight = 1e-6;       ///< permeability of a structure or lining over the least of the soils

HeadGrid grid_of(const Spec& spec) {
  const double width = spec.box.x_max - spec.box.x_min;
  const double height = spec.box.y_max - spec.box.y_min;
  int finest = 0;
  for (const mesh::Refinement& refine : spec.refine)
    finest = std::max(finest, refine.level);
  HeadGrid grid{.x0 = spec.box.x_min, .y0 = spec.box.y_min, .h = mesh::cell_size(spec.cell_size, finest)};
  while ((width / grid.h + 1.0) * (height / grid.h + 1.0) > most_nodes && width / grid.h >= 4.0)
    grid.h *= 2.0;
  const double cells = std::round(width / grid.h); // a side lies between nodes where cells were joined
  grid.columns = static_cast<std::size_t>(cells) + 1;
  grid.h = width / cells;
  grid.rows = static_cast<std::size_t>(std::ceil(height / grid.h - 1e-6)) + 1;
  return grid;
}

double permeability(const Spec& spec, std::size_t soil) {
  const Soil& of = spec.soils[soil];
  if (!of.pores || !(of.pores->permeability > 0.0))
    throw std::invalid_argument(fmt::format(
        "soil '{}' has no permeability, and water seeps through all of the ground: give it one", of.name));
  return of.pores->permeability;
}

/// The permeability at a point of the ground; nothing outside of all regions.
class Permeabilities {
public:
  explicit Permeabilities(const Spec& spec) : spec_(spec) {
    for (const Region& region : spec.regions)
      for (std::size_t slice = 0; slice <= region.cuts.size(); ++slice)
        least_ = std::min(least_, permeability(spec, region.soil + slice));
  }

  std::optional<double> at(double x, double y) const {
    const auto holds = [&](const auto& body) { return mesh::inside(body.outline, x, y); };
    if (std::ranges::any_of(spec_.structures, holds) || std::ranges::any_of(spec_.linings, holds))
      return tight * least_;
    const auto region = std::find_if(spec_.regions.rbegin(), spec_.regions.rend(),
                                     [&](const Region& r) { return mesh::inside(r.polygon, x, y); });
    if (region == spec_.regions.rend())
      return std::nullopt;
    return permeability(spec_, soil_at(region->soil, region->cuts, y));
  }

private:
  const Spec& spec_;
  double least_ = std::numeric_limits<double>::infinity();
};

void place_nodes(GroundMesh& mesh, const Spec& spec) {
  const HeadGrid& grid = mesh.grid;
  const double aside = mesh::alignment_tolerance(grid.h);
  for (std::size_t i = 0; i < grid.columns; ++i) {
    const double x = grid.position(i, 0).x;
    mesh.left_of.push_back(i > 0 ? ground_at(spec, x - aside) : spec.box.y_min);
    mesh.right_of.push_back(i + 1 < grid.columns ? ground_at(spec, x + aside) : spec.box.y_min);
    if (std::abs(mesh.left_of[i] - mesh.right_of[i]) < mesh.slack()) // a slope, and no wall
      mesh.left_of[i] = mesh.right_of[i] = 0.5 * (mesh.left_of[i] + mesh.right_of[i]);
  }
  for (std::size_t j = 0; j < grid.rows; ++j)
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const Vector at = grid.position(i, j);
      mesh.problem.nodes.push_back(at);
    }
  for (std::size_t i = 0; i < grid.columns; ++i)
    for (const double level : {std::min(mesh.left_of[i], mesh.right_of[i]), mesh.ground(i)})
      if (const double row = std::round((level - grid.y0) / grid.h); row >= 1.0)
        mesh.problem.nodes[grid.node(i, static_cast<std::size_t>(row))].y = level;
}

/// The corners of a cell that belong to the ground, counter-clockwise.
seepage::Element element_of(const GroundMesh& mesh, std::size_t i, std::size_t j) {
  const HeadGrid& grid = mesh.grid;
  const std::array<std::pair<std::size_t, double>, 4> corners{{
      {grid.node(i, j), mesh.right_of[i]},
      {grid.node(i + 1, j), mesh.left_of[i + 1]},
      {grid.node(i + 1, j + 1), mesh.left_of[i + 1]},
      {grid.node(i, j + 1), mesh.right_of[i]},
  }};
  seepage::Element element;
  element.corners = 0;
  for (const auto& [node, ground] : corners)
    if (mesh.problem.nodes[node].y <= ground + mesh.slack())
      element.nodes[element.corners++] = node;
  return element;
}

void find_elements(GroundMesh& mesh, const Spec& spec) {
  const Permeabilities permeabilities(spec);
  for (std::size_t j = 0; j + 1 < mesh.grid.rows; ++j)
    for (std::size_t i = 0; i + 1 < mesh.grid.columns; ++i) {
      seepage::Element element = element_of(mesh, i, j);
      if (element.corners < 3)
        continue;
      Vector centre;
      for (std::size_t c = 0; c < element.corners; ++c) {
        centre.x += mesh.problem.nodes[element.nodes[c]].x / static_cast<double>(element.corners);
        centre.y += mesh.problem.nodes[element.nodes[c]].y / static_cast<double>(element.corners);
      }
      if (const std::optional<double> k = permeabilities.at(centre.x, centre.y)) {
        element.permeability = *k;
        mesh.problem.elements.push_back(element);
      }
    }
}

/// Edges of one element alone border on what is not ground. Those that face down are sealed, as the base is.
void find_edges(GroundMesh& mesh) {
  struct Edge {
    int elements = 0;
    bool faces_down = false;
  };
  std::map<std::pair<std::size_t, std::size_t>, Edge> edges;
  for (const seepage::Element& element : mesh.problem.elements)
    for (std::size_t c = 0; c < element.corners; ++c) {
      const std::size_t from = element.nodes[c];
      const std::size_t to = element.nodes[(c + 1) % element.corners];
      Edge& edge = edges[std::minmax(from, to)];
      ++edge.elements;
      edge.faces_down = mesh.column(to) > mesh.column(from); // corners run counter-clockwise
    }
  const std::size_t last = mesh.grid.columns - 1;
  for (const auto& [nodes, edge] : edges) {
    if (edge.elements > 1 || edge.faces_down)
      continue;
    const auto& [a, b] = nodes;
    const auto both_in = [&](std::size_t column) {
      return mesh.column(a) == column && mesh.column(b) == column;
    };
    std::vector<std::size_t>& to = both_in(0) ? mesh.left : both_in(last) ? mesh.right : mesh.surface;
    to.push_back(a);
    to.push_back(b);
  }
}

} // namespace

double ground_at(const Spec& spec, double x) {
  double highest = spec.box.y_min;
  for (const Region& region : spec.regions)
    for (std::size_t i = 0, j = region.polygon.size() - 1; i < region.polygon.size(); j = i++) {
      const Vector& a = region.polygon[j];
      const Vector& b = region.polygon[i];
      if ((a.x > x) != (b.x > x))
        highest = std::max(highest, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
    }
  return std::min(highest, spec.box.y_max);
}

GroundMesh mesh_of(const Spec& spec) {
  GroundMesh mesh;
  mesh.grid = grid_of(spec);
  mesh.problem.transition = 0.25 * mesh.grid.h;
  place_nodes(mesh, spec);
  find_elements(mesh, spec);
  find_edges(mesh);
  return mesh;
}

} // namespace tremolo::mpm_domain
