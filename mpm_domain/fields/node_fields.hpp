#pragma once

// What every node of the grid carries, one array a quantity. A pass names the group of fields that it works
// on; clearing, folding of tied nodes, resizing and checkpoints run over a group and never over a list of
// their own.

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace tremolo::mpm_domain {

/// One double a node, row after row, lattice after lattice.
using NodeField = std::vector<double>;

/// How the values of a group come about.
enum class NodeGroup {
  mass,         ///< summed over particles, while they stay where they are
  momentum,     ///< summed over particles
  force,        ///< summed over particles and boundary faces
  velocity,     ///< derived: before and after the update, and that which strains the soil
  acceleration, ///< derived
  cell,         ///< summed over the particles of the cell that begins at the node
};

struct NodeFields {
  NodeField mass;                   ///< kg/m
  NodeField momentum_x, momentum_y; ///< kg/s
  NodeField force_x, force_y;       ///< N/m
  NodeField dashpot_x, dashpot_y;   ///< boundary dashpots lumped to the node, Pa s
  NodeField vx_before, vy_before;   ///< v-, before the update, m/s
  NodeField vx_after, vy_after;     ///< v+, after the update, m/s
  NodeField vx_strain,
      vy_strain;    ///< u, remapped from the particles after they took v+; musl strains with it, m/s
  NodeField ax, ay; ///< of the last update, m/s2
  /// Sums over the cell to the right of and above the node: the volume of its particles (m2) and the increase
  /// of that volume in this step (m2).
  NodeField cell_volume, cell_dilation;
};

/// A line of the table.
struct NodeFieldDescription {
  std::string_view name;
  std::string_view unit;
  NodeGroup group;
  NodeField NodeFields::*field;
};

inline constexpr std::array node_field_table{
    NodeFieldDescription{"mass", "kg/m", NodeGroup::mass, &NodeFields::mass},
    NodeFieldDescription{"momentum_x", "kg/s", NodeGroup::momentum, &NodeFields::momentum_x},
    NodeFieldDescription{"momentum_y", "kg/s", NodeGroup::momentum, &NodeFields::momentum_y},
    NodeFieldDescription{"force_x", "N/m", NodeGroup::force, &NodeFields::force_x},
    NodeFieldDescription{"force_y", "N/m", NodeGroup::force, &NodeFields::force_y},
    NodeFieldDescription{"dashpot_x", "Pa s", NodeGroup::force, &NodeFields::dashpot_x},
    NodeFieldDescription{"dashpot_y", "Pa s", NodeGroup::force, &NodeFields::dashpot_y},
    NodeFieldDescription{"vx_before", "m/s", NodeGroup::velocity, &NodeFields::vx_before},
    NodeFieldDescription{"vy_before", "m/s", NodeGroup::velocity, &NodeFields::vy_before},
    NodeFieldDescription{"vx_after", "m/s", NodeGroup::velocity, &NodeFields::vx_after},
    NodeFieldDescription{"vy_after", "m/s", NodeGroup::velocity, &NodeFields::vy_after},
    NodeFieldDescription{"vx_strain", "m/s", NodeGroup::velocity, &NodeFields::vx_strain},
    NodeFieldDescription{"vy_strain", "m/s", NodeGroup::velocity, &NodeFields::vy_strain},
    NodeFieldDescription{"ax", "m/s2", NodeGroup::acceleration, &NodeFields::ax},
    NodeFieldDescription{"ay", "m/s2", NodeGroup::acceleration, &NodeFields::ay},
    NodeFieldDescription{"cell_volume", "m2", NodeGroup::cell, &NodeFields::cell_volume},
    NodeFieldDescription{"cell_dilation", "m2", NodeGroup::cell, &NodeFields::cell_dilation},
};

/// The fields that particles add up to, in the order in which tiles keep their sums.
enum class Sum : std::size_t { mass, momentum_x, momentum_y, force_x, force_y, cell_volume, cell_dilation };
inline constexpr std::array particle_sums{
    &NodeFields::mass,    &NodeFields::momentum_x,  &NodeFields::momentum_y,   &NodeFields::force_x,
    &NodeFields::force_y, &NodeFields::cell_volume, &NodeFields::cell_dilation};

/// act(field) for every field of a group.
template <typename Act>
constexpr void for_group(NodeFields& fields, NodeGroup group, const Act& act) {
  for (const NodeFieldDescription& line : node_field_table)
    if (line.group == group)
      act(fields.*line.field);
}

/// Bytes of one node.
inline constexpr std::size_t bytes_per_node = node_field_table.size() * sizeof(double);

} // namespace tremolo::mpm_domain
