#pragma once

#include "mpm_domain/clocks/clock_map.hpp"
#include "mpm_domain/dispersion/skirt.hpp"
#include "mpm_domain/grid/across_weights.hpp"
#include "mpm_domain/grid/body_lattices.hpp"
#include "mpm_domain/grid/graded_mesh.hpp"
#include "mpm_domain/grid/grid.hpp"
#include "mpm_domain/grid/soil_rows.hpp"
#include "mpm_domain/head/head.hpp"
#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/spec/spec.hpp"
#include "mpm_domain/tiles/cell_runs.hpp"
#include "mpm_domain/tiles/deal.hpp"
#include "mpm_domain/tiles/tile_map.hpp"
#include "mpm_domain/tiles/tile_sums.hpp"
#include "mpm_domain/tiles/worker_pool.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The particles of a set in one block that touch several lattices.
struct AcrossTile {
  std::size_t tile;
  std::size_t set;
  AcrossWeights weights;
  std::vector<double> sums; ///< what they bring to nodes: [field of particle_sums][place of a four][lane]
};

/// Strain increments of the particles of a set that wait for the mean of their cells (cell_dilatation.hpp).
struct WaitingStrains {
  std::vector<double> exx, eyy, gxy, wxy;
  std::vector<std::size_t> cell; ///< the node that it begins at

  void resize(std::size_t particles) {
    for (std::vector<double>* field : {&exx, &eyy, &gxy, &wxy})
      field->resize(particles);
    cell.resize(particles);
  }
};

/// Changes of the pore pressure of the particles of a set that wait for their means (pore_pressure.hpp).
struct WaitingPressures {
  std::vector<double> compression; ///< -V div(v_s + n w) dt, m2
  std::vector<double> excess;      ///< W p_e, N; after the filter its mean in the cell, p_e, Pa
  std::vector<std::size_t> cell;   ///< of particles across lattices: the node that it begins at
  std::vector<CellRuns> runs;      ///< by tile: the others, as they bring their pore volumes to nodes

  void resize(std::size_t particles) {
    compression.resize(particles);
    excess.resize(particles);
    cell.resize(particles);
  }
};

/// The tiles that hold particles of one clock, as of the last sort.
struct ClockTiles {
  TileSums sums;                  ///< of particles on one lattice
  std::vector<AcrossTile> across; ///< by set and tile
};

/// A node of a lattice.
struct NodePosition {
  int level;
  int column;
  int row;
  Vector at; ///< m
};

/// The ground of the two-dimensional plane-strain domain: particles, grid, and what orders them. Boundary,
/// contact and ledger are those of the Domain, which is a Ground (domain.hpp); rooms that need none of these
/// take a Ground. What happens to it in a step stands in the passes (scatter, grid_update, gather, ...),
/// which the Stepper strings together.
///
/// Where ranks share ground (particles/share_out.hpp), each has the particles of its own tiles, and takes
/// sums for all nodes in the windows of these. None ever has all particles: they fill it together.
struct Ground {
  /// Fills the regions with particles at rest and without stress.
  /// @param ranks  those that fill it together, each its part, all with the same spec. Each has the elastic
  ///               bodies, which the Domain leaves to the first one; the first sort gives particles to the
  ///               ranks of their tiles. It outlives this. Null: all is filled here
  /// @throws std::invalid_argument for a spec that cannot be built
  explicit Ground(const Spec& specification, Communicator* ranks = nullptr);
  ~Ground();

  Spec spec;
  std::optional<Head> head; ///< of the undisturbed water; none without water
  Grid grid;
  std::optional<GradedMesh> mesh; ///< where the spec refines; without it the grid is one lattice
  Prolongation images;            ///< of periodic sides without a mesh: ties()
  std::vector<std::size_t>
      image_rows;                  ///< rows of ties() at which cells with soil may begin: images of a period
  ClockMap clocks;                 ///< one clock unless the spec sub-cycles
  std::vector<Particles> sets;     ///< one per soil, level by level, then those of elastic bodies
  std::size_t soil_sets = 0;       ///< how many of them are of soil
  std::vector<BodyLattice> bodies; ///< of elastic bodies
  std::vector<WaitingStrains> waiting_strains;     ///< by set, within a gather
  std::vector<WaitingPressures> waiting_pressures; ///< by set, while pore pressures are found
  BasisCells basis_cells; ///< of the mesh, as far as particles across lattices touch them
  TileMap tiles;
  std::optional<RankShare> share;      ///< of this rank; none: the ground is whole
  std::optional<Skirt> skirt;          ///< where ranks share ground with reduced dispersion
  std::vector<ClockTiles> clock_tiles; ///< by clock
  std::vector<NodeRange> soil_rows;    ///< see find_soil_rows
  std::vector<std::size_t> soil_ties;  ///< see find_soil_ties
  WorkerPool workers;
  WindowPool windows;

  bool has_water() const { return grid.traits.wet; }
  bool has_flow() const { return grid.traits.flowing; }
  bool has_seepage() const { return grid.traits.seeping; } ///< whether the head varies
  bool has_pore_pressure() const;
  bool is_sharp() const { return grid.traits.sharp; } ///< whether dispersion is reduced
  /// Whether strains use the velocity remapped from the particles.
  bool is_remapped() const { return spec.scheme.order == StepOrder::musl; }
  std::span<Particles> sets_of_soil() { return std::span(sets).first(soil_sets); }
  std::span<const Particles> sets_of_soil() const { return std::span(sets).first(soil_sets); }
  /// The sets of one elastic body.
  std::span<const Particles> sets_of_body(std::size_t body) const;
  std::span<const Particles> body_sets() const { return std::span(sets).subspan(soil_sets); }
  /// Lattices of the soil are numbered by level; those of elastic bodies follow.
  int soil_lattice_count() const { return mesh ? static_cast<int>(mesh->lattices().size()) : 1; }
  int lattice_count() const { return soil_lattice_count() + static_cast<int>(bodies.size()); }
  const Lattice& lattice(int level) const {
    if (level >= soil_lattice_count())
      return bodies[static_cast<std::size_t>(level - soil_lattice_count())].lattice;
    return level == 0 ? grid : mesh->lattices()[static_cast<std::size_t>(level)];
  }
  /// The finest lattice of the soil.
  const Lattice& finest_lattice() const { return lattice(soil_lattice_count() - 1); }
  /// l of the box of particles that belong to the cells of a level, at the start, m
  double half_size(int level = 0) const;
  Axis x_axis(int level = 0) const { return {lattice(level).x0, lattice(level).h}; }
  Axis y_axis(int level = 0) const { return {lattice(level).y0, lattice(level).h}; }
  std::size_t particle_count() const;
  /// Number of a block. A block holds the particles of one tile that run on one clock and touch one lattice;
  /// blocks are numbered clock after clock. As many blocks follow for particles that touch several lattices,
  /// which belong to a tile of the finest of these.
  std::size_t block(int clock, std::size_t tile) const {
    return static_cast<std::size_t>(clock) * tiles.count() + tile;
  }
  std::size_t across_block(int clock, std::size_t tile) const { return block_count() + block(clock, tile); }
  std::size_t block_count() const { return static_cast<std::size_t>(clocks.count()) * tiles.count(); }
  std::size_t across_block_count() const { return mesh ? block_count() : 0; }
  /// Number of the lattice that the tile of a block belongs to.
  int level_of_block(std::size_t block) const { return tiles.level_of(block % tiles.count()); }
  int clock_of_block(std::size_t block) const {
    return static_cast<int>(block % block_count() / tiles.count());
  }
  /// Number of node rows of all lattices together.
  std::size_t row_count() const;
  /// The nodes of one of these rows, counted lattice after lattice.
  NodeRange row(std::size_t row) const;
  /// Nodes whose motion is that of others: images of a period, and the tied nodes of a graded mesh.
  const Prolongation& ties() const { return mesh ? mesh->prolongation() : images; }
  /// Those that share it; null: there is one process.
  Communicator* ranks() const { return share ? share->ranks : nullptr; }
  /// Whether this rank computes structures, linings, props and surface loads: the first rank does.
  bool has_structures_here() const;
  /// Position of a node.
  NodePosition position_of(std::size_t node) const;
  /// Those that time what tiles cost; null: there is one process.
  TileTimes* tile_times() { return share ? &share->times : nullptr; }
  /// Whether nodes of one row and one tile count here, not on another rank.
  bool counts(const NodeRange& nodes) const;
  /// Largest motion of a particle allowed between two sorts, m.
  double sort_distance() const;
  /// Largest distance from a structure at which soil may touch it before the next sort, m: particles reach
  /// two cells, and both they and the structure move.
  double reach_of_structures() const;
  double fastest_wave(); ///< largest c_p of the particles in their present stress, m/s
};

/// Builds the ties on the present extent of the grid, and the graded mesh if the spec refines; then all
/// fields become zero.
void rebuild_mesh(Ground& ground);

/// Names a particle that something rides on, which is then never cut (splitting.hpp).
void keep_whole(Ground& ground, std::size_t set, std::uint32_t id);

/// Orders all particles by tile and cell; the grid's fields become zero. Where ranks share the ground,
/// particles move to the rank of their tile. What particles may touch must be found next: find_reach().
/// @throws std::runtime_error if a particle has left the grid, naming its position
void order_particles(Ground& ground);

/// Finds what particles may touch until the next sort, and the weights of those across several lattices.
/// @param shared_nodes  which this rank needs besides, where ranks share the ground
void find_reach(Ground& ground, std::span<const std::size_t> shared_nodes);

/// Computes the weights of particles that touch several lattices at their present positions, for the given
/// clock and all faster ones.
void weigh_across(Ground& ground, int slowest_clock = 0);

/// A node with less mass than this (kg/m) counts as empty. Boxes that reach a node by 1e-10 of a cell leave
/// it with this mass, since mass grows with the square of that length. Soil at rest moves by far less, and
/// the momentum of so small a mass does not show. Without a limit, the smallest motion of soil whose surface
/// lies on nodes would make these nodes pull at it.
double empty_mass(const Ground& ground);

/// Soil is shaken or reconsolidates (materials::after_shaking), and its water flows, as the clock says.
/// @param time  that the ground has come to, s
void follow_clock(Ground& ground, double time);

/// Puts a head in the place of that of the undisturbed water: pore pressures become those that go with it,
/// and the grid's fields zero. Which soil is wet stays as it was at the start.
void take_head(Ground& ground, Head head);

/// Particle updates in a step of clock 0, summed over the particles of all ranks.
double particle_updates_per_step(const Ground& ground);

} // namespace tremolo::mpm_domain
