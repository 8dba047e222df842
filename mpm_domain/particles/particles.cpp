#include "mpm_domain/particles/particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

materials::Points Particles::points(std::size_t first, std::size_t count) {
  materials::Points points;
  points.count = count;
  points.sxx = sxx.data() + first;
  points.syy = syy.data() + first;
  points.szz = szz.data() + first;
  points.sxy = sxy.data() + first;
  points.state = state.data() + first * state_size;
  return points;
}

namespace {

[[noreturn]] void refuse_outside(const Particles& p, std::size_t k, const mesh::Rectangle& allowed) {
  throw std::runtime_error(fmt::format("particle {} of soil '{}' has left the grid: x = {:.6g} m, y = "
                                       "{:.6g} m; allowed x {:.6g} to {:.6g} m, y {:.6g} "
                                       "to {:.6g} m",
                                       p.id[k], p.soil, p.x[k], p.y[k], allowed.x_min, allowed.x_max,
                                       allowed.y_min, allowed.y_max));
}

/// The first node of a particle's stencil on a lattice.
struct FirstNode {
  int column, row;
};

FirstNode first_node(const Particles& p, std::size_t k, const Lattice& lattice) {
  const Axis x_axis(lattice.x0, lattice.h);
  const Axis y_axis(lattice.y0, lattice.h);
  return {cell_weights(p.x[k], x_axis, p.half_size).base,
          p.has_own_boxes() ? cell_weights(p.y[k], y_axis, p.half_size).base
                            : gimp_weights(p.y[k], y_axis, p.half_size).base};
}

/// Sort key of a particle: its block, and within the block the first node of its stencil.
/// @param first_block  block that belongs to the first tile
std::size_t key_of(const Particles& p, std::size_t k, const TileMap& tiles, int level,
                   std::size_t first_block) {
  const auto [column, row] = first_node(p, k, tiles.lattice(level));
  const int cell = std::max(row, 0) % tile_rows * tile_columns + std::max(column, 0) % tile_columns;
  return (first_block + tiles.tile_of(level, column, row)) * cells_per_tile + static_cast<std::size_t>(cell);
}

/// Where a key begins among sorted ones.
class Begins {
public:
  Begins(std::span<const std::size_t> key, std::size_t blocks) : first_of_(blocks + 1, 0) {
    for (const std::size_t one : key)
      first_of_[one / cells_per_tile] = 1;
    // Blocks with particles are numbered; a rank has few of all.
    std::size_t filled = 0;
    for (std::size_t& first : first_of_)
      first = std::exchange(filled, filled + first) * cells_per_tile;
    start_.assign(filled * cells_per_tile + 1, 0);
    for (const std::size_t one : key)
      ++start_[at(one) + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    next_ = start_;
  }

  std::size_t of_block(std::size_t block) const { return start_[first_of_[block]]; }
  /// The next place of a key.
  std::size_t take(std::size_t key) { return next_[at(key)]++; }

private:
  std::size_t at(std::size_t key) const { return first_of_[key / cells_per_tile] + key % cells_per_tile; }

  std::vector<std::size_t> first_of_; ///< by block: of its keys among those of blocks with particles
  std::vector<std::size_t> start_;    ///< of these keys, and the end
  std::vector<std::size_t> next_;
};

/// Sorts the particles by their keys, stably, and finds where each block begins.
void order_by(Particles& particles, std::span<const std::size_t> key, std::size_t blocks) {
  const std::size_t n = particles.size();
  Begins begins(key, blocks);
  std::vector<std::size_t> from(n);
  for (std::size_t k = 0; k < n; ++k)
    from[begins.take(key[k])] = k;

  std::vector<double> old;
  particles.for_fields([&](const ParticleFieldDescription&, std::vector<double>& values) {
    old = values;
    for (std::size_t k = 0; k < n; ++k)
      values[k] = old[from[k]];
  });
  old = particles.state;
  const std::size_t width = particles.state_size;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t s = 0; s < width; ++s)
      particles.state[k * width + s] = old[from[k] * width + s];
  const std::vector<std::uint32_t> old_id = particles.id;
  particles.index_of.give(n); // ids of cut particles stay
  for (std::size_t k = 0; k < n; ++k) {
    particles.id[k] = old_id[from[k]];
    particles.index_of.put(particles.id[k], k);
  }
  particles.block_start.clear();
  for (std::size_t block = 0; block <= blocks; ++block)
    particles.block_start.push_back(begins.of_block(block));
}

} // namespace

Particles empty_like(const Particles& set) {
  Particles empty;
  static_cast<KindOfParticles&>(empty) = static_cast<const KindOfParticles&>(set);
  empty.more.resize(set.more.size());
  empty.index_of.give(set.index_of.size());
  return empty;
}

std::size_t tile_of(const Particles& particles, std::size_t k, const TileMap& tiles, int level) {
  const auto [column, row] = first_node(particles, k, tiles.lattice(level));
  return tiles.tile_of(level, column, row);
}

void sort_by_cell(Particles& particles, const TileMap& tiles, int level, std::size_t blocks) {
  const Lattice& grid = tiles.lattice(level);
  // The margin is there because a particle may move by one cell before the next sort. NaN fails every
  // comparison.
  const mesh::Rectangle allowed{grid.x0 + 2 * grid.h, grid.y0 + 2 * grid.h, grid.x0 + (grid.nx - 3) * grid.h,
                                grid.y0 + (grid.ny - 3) * grid.h};
  std::vector<std::size_t> key(particles.size());
  for (std::size_t k = 0; k < key.size(); ++k) {
    const double x = particles.x[k];
    const double y = particles.y[k];
    if (!(x >= allowed.x_min && x < allowed.x_max && y >= allowed.y_min && y < allowed.y_max))
      refuse_outside(particles, k, allowed);
    key[k] = key_of(particles, k, tiles, level, 0);
  }
  order_by(particles, key, blocks);
}

LatticeOfParticle lattice_of(const Particles& particles, std::size_t k, const GradedMesh& mesh,
                             double margin) {
  const GradedMesh::Touched touches = mesh.touched(reach_of(particles, k, margin));
  const Lattice& lattice = mesh.lattices()[static_cast<std::size_t>(touches.finest)];
  const Vector half = half_sides(particles, k);
  const double most = particles.has_own_boxes() ? lattice.h : 0.5001 * lattice.h;
  return {touches.finest, touches.one_lattice() && half.x <= most && half.y <= most};
}

void sort_by_lattice(Particles& particles, const GradedMesh& mesh, const TileMap& tiles,
                     const ClockMap& clocks, double margin) {
  const mesh::Roots& roots = mesh.tree().roots();
  const double reach = (particles.has_own_boxes() ? particles.cell_size : particles.half_size) + 2.0 * margin;
  const mesh::Rectangle allowed{roots.x0 + reach, roots.y0 + reach, roots.x0 + roots.nx * roots.h - reach,
                                roots.y0 + roots.ny * roots.h - reach};
  const std::size_t blocks = static_cast<std::size_t>(clocks.count()) * tiles.count();
  std::vector<std::size_t> key(particles.size());
  for (std::size_t k = 0; k < key.size(); ++k) {
    const double x = particles.x[k];
    const double y = particles.y[k];
    // NaN fails every comparison.
    if (!(x > allowed.x_min && x < allowed.x_max && y > allowed.y_min && y < allowed.y_max))
      refuse_outside(particles, k, allowed);
    const LatticeOfParticle of = lattice_of(particles, k, mesh, margin);
    const auto clock = static_cast<std::size_t>(clocks.at(x, y));
    key[k] = key_of(particles, k, tiles, of.level, (of.alone ? 0 : blocks) + clock * tiles.count());
  }
  order_by(particles, key, 2 * blocks);
}

} // namespace tremolo::mpm_domain
