#include "mpm_domain/particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>

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

/// Of particles, const or not.
template <typename Array, typename Set>
std::vector<Array*> columns_of(Set& p, bool affine) {
  std::vector<Array*> all{&p.x,   &p.y,   &p.vx,   &p.vy,     &p.sxx,       &p.syy,
                          &p.szz, &p.sxy, &p.mass, &p.volume, &p.x_initial, &p.y_initial};
  if (affine)
    all.insert(all.end(), {&p.bxx, &p.bxy, &p.byx, &p.byy});
  return all;
}

} // namespace

std::vector<std::vector<double>*> Particles::columns(bool affine) {
  return columns_of<std::vector<double>>(*this, affine);
}

std::vector<const std::vector<double>*> Particles::columns(bool affine) const {
  return columns_of<const std::vector<double>>(*this, affine);
}

namespace {

[[noreturn]] void refuse_outside(const Particles& p, std::size_t k, const mesh::Rectangle& allowed) {
  throw std::runtime_error(fmt::format("particle {} of soil '{}' has left the grid: x = {:.6g} m, y = "
                                       "{:.6g} m; allowed x {:.6g} to {:.6g} m, y {:.6g} "
                                       "to {:.6g} m",
                                       p.id[k], p.soil, p.x[k], p.y[k], allowed.x_min, allowed.x_max,
                                       allowed.y_min, allowed.y_max));
}

std::size_t cell_of(const Particles& p, std::size_t k, const Grid& grid, double half_size) {
  const Weights wx = cell_weights(p.x[k], {grid.x0, grid.h, half_size});
  const Weights wy = gimp_weights(p.y[k], {grid.y0, grid.h, half_size});
  // A particle may move by one cell before the next sort, hence the margin; NaN fails every comparison.
  const bool inside = wx.base >= 1 && wx.base + 5 <= grid.nx && wy.base >= 1 && wy.base + 4 <= grid.ny;
  if (!inside || !std::isfinite(p.x[k]) || !std::isfinite(p.y[k]))
    refuse_outside(p, k,
                   {grid.x0 + 2 * grid.h, grid.y0 + grid.h, grid.x0 + (grid.nx - 3) * grid.h,
                    grid.y0 + (grid.ny - 2) * grid.h});
  return grid.index(wx.base, wy.base);
}

/// Puts the particles in the order of their keys, keeping that of equal ones.
/// @returns the first place of every key, and the end
std::vector<std::size_t> order_by(Particles& particles, std::span<const std::size_t> key, std::size_t keys) {
  const std::size_t n = particles.size();
  std::vector<std::size_t> start(keys + 1, 0);
  for (std::size_t k = 0; k < n; ++k)
    ++start[key[k] + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  std::vector<std::size_t> from(n);
  for (std::size_t k = 0; k < n; ++k)
    from[next[key[k]]++] = k;

  std::vector<double> old;
  for (std::vector<double>* column : particles.columns()) {
    old = *column;
    for (std::size_t k = 0; k < n; ++k)
      (*column)[k] = old[from[k]];
  }
  old = particles.state;
  const std::size_t width = particles.state_size;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t s = 0; s < width; ++s)
      particles.state[k * width + s] = old[from[k] * width + s];
  const std::vector<std::uint32_t> old_id = particles.id;
  particles.index_of.resize(std::max(n, particles.index_of.size())); // ids of cut particles stay
  for (std::size_t k = 0; k < n; ++k) {
    particles.id[k] = old_id[from[k]];
    particles.index_of[particles.id[k]] = static_cast<std::uint32_t>(k);
  }
  return start;
}

/// Adds the first particle of every block of a lattice, whose node (0, 0) has a key.
void add_block_starts(const Lattice& lattice, std::size_t key, std::span<const std::size_t> start,
                      std::vector<std::size_t>& block_start) {
  for (int row = 0; row < lattice.ny; row += rows_per_block)
    block_start.push_back(start[key + static_cast<std::size_t>(row) * static_cast<std::size_t>(lattice.nx)]);
}

} // namespace

void sort_by_cell(Particles& particles, const Grid& grid, double half_size) {
  std::vector<std::size_t> cell(particles.size());
  for (std::size_t k = 0; k < cell.size(); ++k)
    cell[k] = cell_of(particles, k, grid, half_size);
  const std::vector<std::size_t> start = order_by(particles, cell, grid.size());
  particles.block_start.clear();
  add_block_starts(grid, 0, start, particles.block_start);
  particles.block_start.push_back(particles.size());
}

void sort_by_lattice(Particles& particles, const GradedMesh& mesh, const ClockMap& clocks, double margin) {
  const mesh::Roots& roots = mesh.tree().roots();
  const double reach = particles.half_size + margin;
  const mesh::Rectangle allowed{roots.x0 + reach, roots.y0 + reach, roots.x0 + roots.nx * roots.h - reach,
                                roots.y0 + roots.ny * roots.h - reach};
  const std::size_t levels = mesh.lattices().size();
  const std::size_t across = static_cast<std::size_t>(clocks.count()) * mesh.node_count();
  std::vector<std::size_t> key(particles.size());
  for (std::size_t k = 0; k < key.size(); ++k) {
    const double x = particles.x[k];
    const double y = particles.y[k];
    // NaN fails every comparison.
    if (!(x > allowed.x_min && x < allowed.x_max && y > allowed.y_min && y < allowed.y_max))
      refuse_outside(particles, k, allowed);
    const GradedMesh::Touched touches = mesh.touched(box_of(particles, k, margin));
    const Lattice& lattice = mesh.lattices()[static_cast<std::size_t>(touches.finest)];
    const bool on_one = touches.one_lattice() && particles.half_size < 0.5001 * lattice.h;
    const auto clock = static_cast<std::size_t>(clocks.at(x, y));
    key[k] = on_one ? clock * mesh.node_count() +
                          lattice.index(cell_weights(x, {lattice.x0, lattice.h, particles.half_size}).base,
                                        gimp_weights(y, {lattice.y0, lattice.h, particles.half_size}).base)
                    : across + clock * levels + static_cast<std::size_t>(touches.finest);
  }
  const std::size_t across_blocks = static_cast<std::size_t>(clocks.count()) * levels;
  const std::vector<std::size_t> start = order_by(particles, key, across + across_blocks);
  particles.block_start.clear();
  for (std::size_t first = 0; first < across; first += mesh.node_count())
    for (const Lattice& lattice : mesh.lattices())
      add_block_starts(lattice, first + lattice.first, start, particles.block_start);
  for (std::size_t block = 0; block <= across_blocks; ++block)
    particles.block_start.push_back(start[across + block]);
}

} // namespace tremolo::mpm_domain
