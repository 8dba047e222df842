#pragma once

// The structures of a case, as the plan describes them and as rules look at them.

#include "scene/case.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::scene {

/// A structure in numbers, per metre out of plane.
struct PlannedStructure {
  std::string name;
  double area = 0.0;          ///< between outline and hole, m2
  double mass = 0.0;          ///< kg/m
  double weight = 0.0;        ///< N/m
  double buoyancy = 0.0;      ///< weight of the water at rest that its outline displaces, N/m
  double contact_nodes = 0.0; ///< at the start, about
  double bytes = 0.0;         ///< of what contact keeps
};

/// Cost of contact per node and step on one thread, ns; an order of magnitude.
inline constexpr double contact_node_cost_ns = 3000.0;

/// Outlines of all structures and linings that have one.
std::vector<Polygon> outlines(const Case& scene);

/// The polygons of the regions.
std::vector<Polygon> region_polygons(const Case& scene);

/// Side of the cells that structures meet soil on: the finest of the mesh, m.
double contact_cell_size(const Case& scene);

/// Points on a structure's outline with soil next to them, a quarter of a cell apart.
std::vector<Point> points_on_soil(const Case& scene, std::size_t structure);

/// Requires a case without errors.
std::vector<PlannedStructure> plan_structures(const Case& scene);

/// "'tunnel' 5890 kg/m, 57.8 kN/m, net 135 kN/m upwards in water; ...", and what contact costs.
std::string contact_text(std::span<const PlannedStructure> structures);

/// A line for each structure: what it is and what its surface does.
std::string structures_text(const Case& scene, std::span<const PlannedStructure> structures);

} // namespace tremolo::scene
