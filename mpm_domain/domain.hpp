#pragma once

#include "mpm_domain/boundary/boundary.hpp"
#include "mpm_domain/grid/across_weights.hpp"
#include "mpm_domain/grid/graded_mesh.hpp"
#include "mpm_domain/grid/grid.hpp"
#include "mpm_domain/grid/soil_rows.hpp"
#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/spec/spec.hpp"
#include "mpm_domain/step/energy_ledger.hpp"
#include "mpm_domain/tiles/worker_pool.hpp"

#include <optional>
#include <vector>

namespace tremolo::mpm_domain {

/// The state of the two-dimensional plane-strain domain: particles, grid and boundary. What happens to it in
/// a step stands in the passes (scatter, grid_update, gather, ...), which the Stepper strings together.
struct Domain {
  /// Fills the regions with particles at rest and without stress.
  /// @throws std::invalid_argument for a spec that cannot be built
  explicit Domain(const Spec& specification);

  Spec spec;
  Grid grid;
  std::optional<GradedMesh> mesh; ///< where the spec refines; without it the grid is one lattice
  Prolongation images;            ///< of periodic sides without a mesh: ties()
  ClockMap clocks;                ///< one clock unless the spec sub-cycles
  std::vector<Particles> sets;    ///< one per soil
  Boundary boundary;
  EnergyLedger energy;
  BasisCells basis_cells; ///< of the mesh, as far as particles across lattices touch them
  /// Of the particles that touch several lattices; clock by clock and in it set by set.
  std::vector<AcrossWeights> across;
  std::vector<NodeRange> soil_rows; ///< see find_soil_rows
  WorkerPool workers;

  int lattice_count() const { return mesh ? static_cast<int>(mesh->lattices().size()) : 1; }
  const Lattice& lattice(int level) const {
    return level == 0 ? grid : mesh->lattices()[static_cast<std::size_t>(level)];
  }
  const Lattice& finest_lattice() const { return lattice(lattice_count() - 1); }
  /// l of the box of particles that belong to the cells of a level, at the start, m
  double half_size(int level = 0) const;
  Axis x_axis(int level = 0) const { return {lattice(level).x0, lattice(level).h}; }
  Axis y_axis(int level = 0) const { return {lattice(level).y0, lattice(level).h}; }
  std::size_t particle_count() const;
  /// Blocks of rows: clock after clock, lattice after lattice. Behind them, clock after clock and one for
  /// each level, stand the blocks of particles that touch several lattices, the finest of them this one.
  std::size_t block_count() const { return static_cast<std::size_t>(clocks.count()) * blocks_per_clock(); }
  std::size_t blocks_per_clock() const;
  std::size_t across_block_count() const {
    return mesh ? static_cast<std::size_t>(clocks.count()) * mesh->lattices().size() : 0;
  }
  int lattice_of_block(std::size_t block) const;
  int clock_of_block(std::size_t block) const;
  const AcrossWeights& across_of(std::size_t set, int clock) const {
    return across[static_cast<std::size_t>(clock) * sets.size() + set];
  }
  /// Rows of nodes of all lattices.
  std::size_t row_count() const;
  /// One of them.
  NodeRange row(std::size_t row) const;
  /// Nodes whose motion is that of others: images of a period, and the tied nodes of a graded mesh.
  const Prolongation& ties() const { return mesh ? mesh->prolongation() : images; }
  /// How far particles may move from one sort to the next, m.
  double sort_distance() const;
  double fastest_wave(); ///< largest c_p of the particles in their present stress, m/s
};

/// Blocks of rows of a lattice.
std::size_t blocks_of(const Lattice& lattice);

/// Builds the ties on the present extent of the grid, and the graded mesh if the spec refines; then all
/// fields become zero.
void rebuild_mesh(Domain& domain);

/// Names a particle that something rides on, which is then never cut (splitting.hpp).
void keep_whole(Domain& domain, std::size_t set, std::uint32_t id);

/// Orders all particles by lattice and cell and finds what they may touch; the grid's fields become zero.
/// @throws std::runtime_error if a particle has left the grid, naming its place
void sort_particles(Domain& domain);

/// Finds what particles may touch until the next sort, and the weights of those across several lattices.
void find_reach(Domain& domain);

/// The weights of particles that touch several lattices, at their present places; those of the given clock
/// and faster ones.
void weigh_across(Domain& domain, int slowest_clock = 0);

/// A node with less mass (kg/m) is empty: boxes reach it by 1e-10 of a cell or less, with whose square its
/// mass goes. Far more than soil at rest moves, and far less than momentum would show: without a least mass,
/// the least motion of soil whose surface lies on nodes would have these nodes pull at it.
double empty_mass(const Domain& domain);

} // namespace tremolo::mpm_domain
