#pragma once

// Quantities at the nodes of the grid, one array each. A pass names the group of fields that it works on;
// clearing, folding of tied nodes and resizing run over a group and never over a list of their own.

#include "mpm_domain/fields/zero_pages.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace tremolo::mpm_domain {

/// One double a node, row after row, lattice after lattice.
using NodeField = ZeroPages<double>;

/// The way in which the values of a group are computed.
enum class NodeGroup {
  mass,           ///< summed over particles, while they stay where they are
  momentum,       ///< summed over particles
  force,          ///< summed over particles and boundary faces
  velocity,       ///< derived: before and after the update, and that which strains the soil
  acceleration,   ///< derived
  cell,           ///< summed over the particles of the cell that begins at the node
  pores,          ///< summed over wet particles, while they stay where they are
  compression,    ///< summed over wet particles, then their mean (pore_pressure.hpp)
  volume_flux,    ///< derived: what changes the pressure of pore water that flows
  openness,       ///< derived: where water may pass
  water_mass,     ///< summed over particles whose water flows, while they stay where they are
  water_momentum, ///< summed over them
  water_force,    ///< summed over them
  water_velocity, ///< derived, as velocity
  fullness,       ///< derived from masses: how much soil there is around a node
  inside,         ///< derived from it: where a node has soil on all sides
  sharpened,      ///< derived
  seepage,        ///< summed over particles under water whose head varies
};

/// The domains that have a group.
enum class NodeTrait {
  always,
  wet,     ///< with soil below the water table
  flowing, ///< with soil whose pore water flows
  sharp,   ///< with reduced dispersion
  seeping, ///< with water whose head varies
};

/// The traits of a domain.
struct NodeTraits {
  bool wet = false;     ///< soil lies below the water table
  bool flowing = false; ///< and water flows in it
  bool sharp = false;   ///< dispersion is reduced
  bool seeping = false; ///< the head of the undisturbed water varies

  constexpr bool have(NodeTrait trait) const {
    switch (trait) {
    case NodeTrait::always:
      return true;
    case NodeTrait::wet:
      return wet;
    case NodeTrait::flowing:
      return flowing;
    case NodeTrait::sharp:
      return sharp;
    case NodeTrait::seeping:
      return seeping;
    }
    return false;
  }
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
  /// Sums over the cell to the right of and above the node, whose ratio is a mean over its particles: their
  /// weights, and these times what changes in the step (cell_means.hpp).
  NodeField cell_weight, cell_change;
  NodeField buoyancy;       ///< of submerged soil, N/m
  NodeField pore_volume;    ///< V n of wet soil, m2
  NodeField compression;    ///< V n e of wet soil, m2; then its mean e (pore_pressure.hpp), 1
  NodeField flux_x, flux_y; ///< v_s + n w: volume of grains and water through unit area, m/s
  NodeField open_x, open_y; ///< 1, or 0 where water may not move against the grains in this direction
  NodeField water_mass;     ///< m_f, kg/m
  NodeField wet_volume;     ///< volume of the soil whose water flows, m2
  NodeField resistance;     ///< that volume times rho_f g/k, Pa s
  NodeField water_momentum_x, water_momentum_y; ///< kg/s
  NodeField water_force_x, water_force_y;       ///< of the excess pressure per unit of water volume, N/m
  NodeField wx_before, wy_before;               ///< of the water, v_f-, m/s
  NodeField wx_after, wy_after;                 ///< v_f+, m/s
  NodeField fullness;                           ///< e (dispersion/fullness.hpp), 1
  NodeField inside_x, inside_y, inside_both;    ///< chi of both directions, and of both together, 1
  NodeField inside_block;         ///< 1 where e is 1 at all 4 x 4 nodes from this one on, else 0
  NodeField seepage_x, seepage_y; ///< seepage force (water/seepage_force.hpp), N/m
  NodeField sharp_x, sharp_y;     ///< what sharpening gives, m/s or N/m (dispersion/sharpening.hpp)
};

/// A line of the table.
struct NodeFieldDescription {
  std::string_view name;
  std::string_view unit;
  NodeGroup group;
  NodeField NodeFields::*field;
  NodeTrait trait = NodeTrait::always;
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
    NodeFieldDescription{"cell_weight", "that of the mean", NodeGroup::cell, &NodeFields::cell_weight},
    NodeFieldDescription{"cell_change", "that of the mean", NodeGroup::cell, &NodeFields::cell_change},
    NodeFieldDescription{"buoyancy", "N/m", NodeGroup::pores, &NodeFields::buoyancy, NodeTrait::wet},
    NodeFieldDescription{"pore_volume", "m2", NodeGroup::pores, &NodeFields::pore_volume, NodeTrait::wet},
    NodeFieldDescription{"compression", "m2", NodeGroup::compression, &NodeFields::compression,
                         NodeTrait::wet},
    NodeFieldDescription{"flux_x", "m/s", NodeGroup::volume_flux, &NodeFields::flux_x, NodeTrait::flowing},
    NodeFieldDescription{"flux_y", "m/s", NodeGroup::volume_flux, &NodeFields::flux_y, NodeTrait::flowing},
    NodeFieldDescription{"open_x", "1", NodeGroup::openness, &NodeFields::open_x, NodeTrait::flowing},
    NodeFieldDescription{"open_y", "1", NodeGroup::openness, &NodeFields::open_y, NodeTrait::flowing},
    NodeFieldDescription{"water_mass", "kg/m", NodeGroup::water_mass, &NodeFields::water_mass,
                         NodeTrait::flowing},
    NodeFieldDescription{"wet_volume", "m2", NodeGroup::water_mass, &NodeFields::wet_volume,
                         NodeTrait::flowing},
    NodeFieldDescription{"resistance", "Pa s", NodeGroup::water_mass, &NodeFields::resistance,
                         NodeTrait::flowing},
    NodeFieldDescription{"water_momentum_x", "kg/s", NodeGroup::water_momentum, &NodeFields::water_momentum_x,
                         NodeTrait::flowing},
    NodeFieldDescription{"water_momentum_y", "kg/s", NodeGroup::water_momentum, &NodeFields::water_momentum_y,
                         NodeTrait::flowing},
    NodeFieldDescription{"water_force_x", "N/m", NodeGroup::water_force, &NodeFields::water_force_x,
                         NodeTrait::flowing},
    NodeFieldDescription{"water_force_y", "N/m", NodeGroup::water_force, &NodeFields::water_force_y,
                         NodeTrait::flowing},
    NodeFieldDescription{"wx_before", "m/s", NodeGroup::water_velocity, &NodeFields::wx_before,
                         NodeTrait::flowing},
    NodeFieldDescription{"wy_before", "m/s", NodeGroup::water_velocity, &NodeFields::wy_before,
                         NodeTrait::flowing},
    NodeFieldDescription{"wx_after", "m/s", NodeGroup::water_velocity, &NodeFields::wx_after,
                         NodeTrait::flowing},
    NodeFieldDescription{"wy_after", "m/s", NodeGroup::water_velocity, &NodeFields::wy_after,
                         NodeTrait::flowing},
    NodeFieldDescription{"fullness", "1", NodeGroup::fullness, &NodeFields::fullness, NodeTrait::sharp},
    NodeFieldDescription{"inside_x", "1", NodeGroup::inside, &NodeFields::inside_x, NodeTrait::sharp},
    NodeFieldDescription{"inside_y", "1", NodeGroup::inside, &NodeFields::inside_y, NodeTrait::sharp},
    NodeFieldDescription{"inside_both", "1", NodeGroup::inside, &NodeFields::inside_both, NodeTrait::sharp},
    NodeFieldDescription{"inside_block", "1", NodeGroup::inside, &NodeFields::inside_block, NodeTrait::sharp},
    NodeFieldDescription{"sharp_x", "m/s or N/m", NodeGroup::sharpened, &NodeFields::sharp_x,
                         NodeTrait::sharp},
    NodeFieldDescription{"sharp_y", "m/s or N/m", NodeGroup::sharpened, &NodeFields::sharp_y,
                         NodeTrait::sharp},
    NodeFieldDescription{"seepage_x", "N/m", NodeGroup::seepage, &NodeFields::seepage_x, NodeTrait::seeping},
    NodeFieldDescription{"seepage_y", "N/m", NodeGroup::seepage, &NodeFields::seepage_y, NodeTrait::seeping},
};

/// The fields that particles add up to, in the order in which tiles keep their sums. Those of the water stand
/// in the order of those of the soil.
enum class Sum : std::size_t {
  mass,
  momentum_x,
  momentum_y,
  force_x,
  force_y,
  cell_weight,
  cell_change,
  compression,
  water_mass,
  water_momentum_x,
  water_momentum_y,
  water_force_x,
  water_force_y,
  wet_volume,
  resistance,
  buoyancy,
  pore_volume,
  seepage_x,
  seepage_y,
};
struct SumField {
  Sum sum;
  NodeField NodeFields::*field;
};
inline constexpr std::array sum_table{SumField{Sum::mass, &NodeFields::mass},
                                      SumField{Sum::momentum_x, &NodeFields::momentum_x},
                                      SumField{Sum::momentum_y, &NodeFields::momentum_y},
                                      SumField{Sum::force_x, &NodeFields::force_x},
                                      SumField{Sum::force_y, &NodeFields::force_y},
                                      SumField{Sum::cell_weight, &NodeFields::cell_weight},
                                      SumField{Sum::cell_change, &NodeFields::cell_change},
                                      SumField{Sum::compression, &NodeFields::compression},
                                      SumField{Sum::water_mass, &NodeFields::water_mass},
                                      SumField{Sum::water_momentum_x, &NodeFields::water_momentum_x},
                                      SumField{Sum::water_momentum_y, &NodeFields::water_momentum_y},
                                      SumField{Sum::water_force_x, &NodeFields::water_force_x},
                                      SumField{Sum::water_force_y, &NodeFields::water_force_y},
                                      SumField{Sum::wet_volume, &NodeFields::wet_volume},
                                      SumField{Sum::resistance, &NodeFields::resistance},
                                      SumField{Sum::buoyancy, &NodeFields::buoyancy},
                                      SumField{Sum::pore_volume, &NodeFields::pore_volume},
                                      SumField{Sum::seepage_x, &NodeFields::seepage_x},
                                      SumField{Sum::seepage_y, &NodeFields::seepage_y}};
static_assert(std::ranges::all_of(sum_table, [](const SumField& one) {
  return &one == &sum_table[static_cast<std::size_t>(one.sum)];
}));
inline constexpr auto particle_sums = [] {
  std::array<NodeField NodeFields::*, sum_table.size()> fields{};
  std::ranges::transform(sum_table, fields.begin(), &SumField::field);
  return fields;
}();

/// Fields [first, end) of particle_sums.
struct SumRange {
  std::size_t first;
  std::size_t end;
};
constexpr SumRange sums_between(Sum first, Sum last) {
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(last) + 1};
}

/// The sums that particles above the water table have.
inline constexpr SumRange dry_sums = sums_between(Sum::mass, Sum::force_y);

/// The sums of a scatter of soil with these traits: those of the soil, then those of its water.
constexpr std::array<SumRange, 2> scattered_sums(NodeTraits traits) {
  const SumRange of_water = traits.flowing ? sums_between(Sum::water_mass, Sum::pore_volume)
                                           : sums_between(Sum::buoyancy, Sum::pore_volume);
  return {dry_sums, traits.wet ? of_water : SumRange{0, 0}};
}

/// act(field) for every field of a group.
template <typename Act>
constexpr void for_group(NodeFields& fields, NodeGroup group, const Act& act) {
  for (const NodeFieldDescription& line : node_field_table)
    if (line.group == group)
      act(fields.*line.field);
}

/// Bytes of one node of a domain with these traits.
constexpr std::size_t bytes_per_node(NodeTraits traits = {}) {
  std::size_t fields = 0;
  for (const NodeFieldDescription& line : node_field_table)
    fields += traits.have(line.trait) ? 1 : 0;
  return fields * sizeof(double);
}

} // namespace tremolo::mpm_domain
