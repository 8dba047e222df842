#pragma once

// The pore water before a lining, as contact asks for it: at the nodes of segments (segment_water.hpp), the
// mass of water that filled the soil, and its velocity under its own excess pressure,
//
//     m~_f = rho_f V,      m~_f v_f* = rho_f V v_s + m_f w + dt sum V p_e grad S,
//
// summed over the particles near the lining where water moves with the grains (w = 0), and taken from the
// grid's sums where it flows. Water at a wall reads some of its neighbourhood's flow from the particles: this
// w is stopped anew in every step, and is no stress between grains. What is hydrostatic does not pass through
// contact, but acts on the lining (water_load.hpp).

#include "mpm_domain/contact/contact_nodes.hpp"
#include "mpm_domain/lining/lining_contact.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

struct Ground;

/// @param near  the particles near the lining
/// @param box   around it
/// @param dt    time that forces act for, s
WaterBefore find_water_before(const Ground& ground, std::span<const NearParticle> near,
                              const mesh::Rectangle& box, std::span<const SegmentRows> rows, double dt);

/// The nodes of the rows where water flows. Their normals are means of those of the segments.
std::vector<NodeFlow> find_flows(const Ground& ground, std::span<const SegmentRows> rows, double dt);

/// Lets grains and water have one velocity along the normals of nodes after the update.
void stop_flow(Ground& ground, std::span<const NodeFlow> flows);

} // namespace tremolo::mpm_domain
