#pragma once

#include "mpm_domain/clocks/clock_map.hpp"
#include "mpm_domain/fields/particle_fields.hpp"
#include "mpm_domain/grid/graded_mesh.hpp"
#include "mpm_domain/grid/grid.hpp"
#include "mpm_domain/kernel/kernel.hpp"
#include "mpm_domain/kernel/particle_boxes.hpp"
#include "mpm_domain/particles/places_by_id.hpp"
#include "mpm_domain/particles/water/pore_water.hpp"
#include "mpm_domain/spec/spec.hpp"
#include "mpm_domain/tiles/tile_map.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// Particles [begin, end) of a set.
struct ParticleRange {
  std::size_t begin;
  std::size_t end;
};

/// What all particles of a set have in common.
struct KindOfParticles {
  std::string soil;
  std::size_t soil_index = 0; ///< into Spec::soils
  /// The index in Ground::bodies of the elastic body that the particles are part of. They have no soil_index;
  /// `soil` is the name of the structure.
  std::optional<std::size_t> body = {};
  int level = 0;          ///< of the cells that they belong to by their size
  double cell_size = 0.0; ///< h of these, m
  double half_size = 0.0; ///< l of their boxes, at the start where these follow the soil, m
  materials::Law law;
  double damping_time = 0.0;        ///< beta of the viscous stress, s; only with trait damped
  materials::Relaxation relaxation; ///< mechanisms of constant damping; only with trait damped
  std::size_t first_memory = 0;     ///< of relaxation_fields() in ParticleFields::more
  double density = 0.0;             ///< of what `mass` is, at the start, kg/m3
  double weight_share = 1.0;        ///< weight over mass times gravity: less than 1 below the water table
  std::optional<PoreWater> water;   ///< of wet particles
  bool drains = false; ///< in a static stage: water has time to flow, so that its pressure stays what it is
  std::size_t state_size = 0; ///< doubles per particle in `state`

  ParticleTraits traits;
  std::vector<ParticleFieldDescription> more_fields; ///< of ParticleFields::more
};

/// All particles of one soil, or of an elastic body, and of one size, one array a quantity, ordered by tile
/// and cell.
struct Particles : KindOfParticles, ParticleFields {
  std::vector<std::uint32_t> id; ///< number at creation; the same for the whole run
  std::vector<double> state;     ///< [particle][state_size]

  std::vector<std::size_t> block_start; ///< first particle of each of the domain's blocks, and the end
  PlacesById index_of;
  std::vector<std::uint32_t> whole; ///< ids, ascending, of particles that are never split (splitting.hpp)

  static constexpr std::uint32_t nowhere = PlacesById::nowhere;

  std::size_t size() const { return x.size(); }
  ParticleRange in_block(std::size_t block) const { return {block_start[block], block_start[block + 1]}; }
  /// Stress and state of particles [first, first + count), as laws see them. The caller adds the increments.
  materials::Points points(std::size_t first, std::size_t count);

  /// act(description, values) for every field that the set has, in the order of the table.
  template <typename Act>
  void for_fields(const Act& act) {
    each_field(*this, act);
  }
  template <typename Act>
  void for_fields(const Act& act) const {
    each_field(*this, act);
  }

  /// Whether boxes follow the soil, or all stay one square.
  bool has_own_boxes() const { return traits.own_boxes; }
  BoxLimits box_limits() const { return BoxLimits(cell_size); }

private:
  template <typename Set, typename Act>
  static void each_field(Set& set, const Act& act) {
    for (const ParticleFieldDescription& line : particle_field_table())
      if (set.traits.have(line.trait))
        act(line, set.*line.field);
    for (std::size_t n = 0; n < set.more_fields.size(); ++n)
      act(set.more_fields[n], set.more[n]);
  }
};

/// Makes a set of the same kind without particles, in which as many ids have been given.
Particles empty_like(const Particles& set);

/// The tile that a particle belongs to at its present position on a lattice.
std::size_t tile_of(const Particles& particles, std::size_t k, const TileMap& tiles, int level);

/// The finest lattice of a graded mesh that a particle may touch on a way of `margin` (m), and whether it
/// touches that one alone, as particles of its cells do.
struct LatticeOfParticle {
  int level;
  bool alone;
};
LatticeOfParticle lattice_of(const Particles& particles, std::size_t k, const GradedMesh& mesh,
                             double margin);

/// Orders the particles on one lattice by tile and within a tile by cell, row after row. Particles that share
/// a cell keep their order.
/// @param level   of the lattice
/// @param blocks  of the domain; those of the lattice are its tiles
/// @throws std::runtime_error if a particle has left the lattice, naming its position
void sort_by_cell(Particles& particles, const TileMap& tiles, int level, std::size_t blocks);

/// Half sides of a particle's box, m.
inline Vector half_sides(const Particles& p, std::size_t k) {
  if (!p.has_own_boxes())
    return {p.half_size, p.half_size};
  const BoxLimits limits = p.box_limits();
  return {limits.half_side(p.box_xx[k]), limits.half_side(p.box_yy[k])};
}

/// The box that a particle represents.
inline mesh::Rectangle box_of(const Particles& p, std::size_t k) {
  const Vector l = half_sides(p, k);
  return {p.x[k] - l.x, p.y[k] - l.y, p.x[k] + l.x, p.y[k] + l.y};
}

/// All positions that the box of a particle may come to while particles move by up to a distance (m). The
/// side of a box that follows the soil moves relative to its particle too, by as much again.
inline mesh::Rectangle reach_of(const Particles& p, std::size_t k, double distance) {
  const mesh::Rectangle box = box_of(p, k);
  const double margin = p.has_own_boxes() ? 2.0 * distance : distance;
  return {box.x_min - margin, box.y_min - margin, box.x_max + margin, box.y_max + margin};
}

/// Orders the particles on a graded mesh. Those that touch one lattice come first, by clock, then by tile,
/// then by cell. The others follow, by clock and by tile of the finest lattice that they touch. These are
/// particles whose box touches cells of several lattices or of a virtually split leaf, or might do so before
/// the next sort, and particles whose box is too large for the lattice's kernel: its half side is larger than
/// half a cell, or than a cell where boxes follow the soil.
/// @param margin  how far particles may move until the next sort, m
/// @throws std::runtime_error if a particle has left the mesh, naming its position
void sort_by_lattice(Particles& particles, const GradedMesh& mesh, const TileMap& tiles,
                     const ClockMap& clocks, double margin);

} // namespace tremolo::mpm_domain
