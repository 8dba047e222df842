#pragma once

#include "mpm_domain/boundary/boundary.hpp"
#include "mpm_domain/boundary/load/surface_loads.hpp"
#include "mpm_domain/contact/contact.hpp"
#include "mpm_domain/earthworks/earthworks.hpp"
#include "mpm_domain/ground.hpp"
#include "mpm_domain/lining/linings.hpp"
#include "mpm_domain/passes/energy_ledger.hpp"
#include "mpm_domain/prop/props.hpp"
#include "mpm_domain/section/sections.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// The state of the domain: the ground, its boundary and earthworks, the structures and linings in it, props
/// and cuts of these, and where the energy goes. Where ranks share a domain, each knows the soil and the
/// velocities at the faces of the boundary that it works out; the first one has the velocities at all.
struct Domain : Ground {
  /// Fills the regions with particles at rest and without stress.
  /// @param ranks  those that fill and share it, all with the same spec; it outlives this. None of them ever
  ///               has all of it. Null: there is one process
  /// @throws std::invalid_argument for a spec that cannot be built
  explicit Domain(const Spec& specification, Communicator* ranks = nullptr);
  ~Domain(); // in domain.cpp: it takes down some hundred fields

  Boundary boundary;
  SurfaceLoads loads;
  Earthworks earthworks;
  Contact contact;
  Linings linings;
  Props props;
  Sections sections;
  EnergyLedger energy;
};

/// Orders all particles by tile and cell, lets boundary and structures follow, and finds what particles may
/// touch; the grid's fields become zero.
/// @throws std::runtime_error if a particle has left the grid, naming its position
void sort_particles(Domain& domain);

/// Finds what particles, boundary and structures may touch until the next sort.
void find_reach(Domain& domain);

/// Makes the grid large enough (particles/grid_growth.hpp), within the limits that the boundary sets.
void make_room(Domain& domain, double time, long step);

/// Boxes around all that structures, linings, props and surface loads may touch until the next sort, as far
/// as this rank knows where they are, and else around nothing. From the first sort on, rank 0 knows it.
std::vector<mesh::Rectangle> boxes_of_structures(const Domain& domain);

/// Where it is time to look at what tiles cost, deals them anew if that is uneven (particles/share_out.hpp),
/// and finds what particles may touch.
/// @returns whether they are
bool deal_anew_if_due(Domain& domain);

/// After faces have changed between two sorts, or particles have come to other ranks: these learn of it.
void follow_faces(Domain& domain);

} // namespace tremolo::mpm_domain
