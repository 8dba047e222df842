#include "mpm_domain/grid/body_lattices.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

/// Empty nodes around the cells of particles: one for the way until the next sort, and two for kernels that
/// read whole rows of four nodes.
constexpr int padding = 3;

/// Columns or rows of cells from the first to the last.
struct Extent {
  int first = std::numeric_limits<int>::max();
  int last = std::numeric_limits<int>::min();

  void take(double cells) {
    const auto cell = static_cast<int>(std::floor(cells));
    first = std::min(first, cell);
    last = std::max(last, cell);
  }
  int nodes() const { return last - first + 2 + 2 * padding; }
};

/// The extents of the bodies on the rank that has their particles become those on all.
void take_over_ranks(const Ground& ground, std::vector<Extent>& extents) {
  std::vector<double> outwards;
  for (const Extent& extent : extents)
    outwards.insert(outwards.end(), {-static_cast<double>(extent.first), static_cast<double>(extent.last)});
  ground.share->ranks->largest(outwards);
  for (std::size_t b = 0; b < extents.size(); ++b)
    extents[b] = {-static_cast<int>(outwards[2 * b]), static_cast<int>(outwards[2 * b + 1])};
}

} // namespace

void follow_bodies(Ground& ground) {
  if (ground.bodies.empty())
    return;
  const Lattice& soil = ground.finest_lattice();
  std::vector<Extent> columns(ground.bodies.size());
  std::vector<Extent> rows(ground.bodies.size());
  for (const Particles& set : ground.body_sets())
    for (std::size_t k = 0; k < set.size(); ++k) {
      columns[*set.body].take((set.x[k] - soil.x0) / soil.h);
      rows[*set.body].take((set.y[k] - soil.y0) / soil.h);
    }
  if (ground.share) {
    take_over_ranks(ground, columns);
    take_over_ranks(ground, rows);
  }
  bool changed = false;
  for (std::size_t b = 0; b < ground.bodies.size(); ++b) {
    BodyLattice& body = ground.bodies[b];
    const BodyLattice last = body;
    body.column = columns[b].first - padding;
    body.row = rows[b].first - padding;
    body.lattice.nx = columns[b].nodes();
    body.lattice.ny = rows[b].nodes();
    changed |= body.column != last.column || body.row != last.row || body.lattice.nx != last.lattice.nx ||
               body.lattice.ny != last.lattice.ny;
  }
  if (changed)
    lay_out_lattices(ground);
}

void lay_out_lattices(Ground& ground) {
  std::vector<Lattice> all;
  for (int level = 0; level < ground.soil_lattice_count(); ++level)
    all.push_back(ground.lattice(level));
  const Lattice soil = all.back();
  std::size_t first = soil.first + soil.count();
  for (BodyLattice& body : ground.bodies) {
    Lattice& own = body.lattice;
    own = {soil.h, soil.x0 + body.column * soil.h, soil.y0 + body.row * soil.h, own.nx, own.ny, first};
    first += own.count();
    all.push_back(own);
  }
  ground.tiles = TileMap(std::move(all));
  resize_fields(ground.grid, first);
}

std::vector<double> lattice_state(const std::vector<BodyLattice>& bodies) {
  std::vector<double> state;
  for (const BodyLattice& body : bodies)
    for (const int number : {body.column, body.row, body.lattice.nx, body.lattice.ny})
      state.push_back(number);
  return state;
}

void set_lattice_state(std::vector<BodyLattice>& bodies, const std::vector<double>& state) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto number = [&](std::size_t n) { return static_cast<int>(state.at(4 * b + n)); };
    bodies[b].column = number(0);
    bodies[b].row = number(1);
    bodies[b].lattice.nx = number(2);
    bodies[b].lattice.ny = number(3);
  }
}

} // namespace tremolo::mpm_domain
