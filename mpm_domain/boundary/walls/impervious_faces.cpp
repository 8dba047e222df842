#include "mpm_domain/boundary/walls/impervious_faces.hpp"

#include "mpm_domain/boundary/boundary.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// Closes the nodes of a lattice on the line of a face, and those next to it outside.
void close_nodes(const Lattice& lattice, Side side, const mesh::Rectangle& line, Grid& grid) {
  const auto nearest = [&](double place, double origin) {
    return static_cast<int>(std::lround((place - origin) / lattice.h));
  };
  const auto first = [&](double place, double origin) {
    return static_cast<int>(std::floor((place - origin) / lattice.h + 1e-9));
  };
  const auto last = [&](double place, double origin) {
    return static_cast<int>(std::ceil((place - origin) / lattice.h - 1e-9));
  };
  const auto close = [&](NodeField& open, int i, int j) {
    if (i >= 0 && i < lattice.nx && j >= 0 && j < lattice.ny)
      open[lattice.index(i, j)] = 0.0;
  };
  if (side == Side::base) {
    const int row = nearest(line.y_min, lattice.y0);
    for (int i = first(line.x_min, lattice.x0); i <= last(line.x_max, lattice.x0); ++i)
      for (const int j : {row, row - 1})
        close(grid.open_y, i, j);
    return;
  }
  const int column = nearest(line.x_min, lattice.x0);
  for (int j = first(line.y_min, lattice.y0); j <= last(line.y_max, lattice.y0); ++j)
    for (const int i : {column, side == Side::left ? column - 1 : column + 1})
      close(grid.open_x, i, j);
}

} // namespace

void ImperviousFaces::close(Ground& ground, const Boundary& boundary) {
  Grid& grid = ground.grid;
  for_group(grid, NodeGroup::openness, [](NodeField& open) { std::ranges::fill(open, 1.0); });
  for (std::size_t f = 0; f < boundary.faces().size(); ++f) {
    const BoundaryFace& face = boundary.faces()[f];
    if (ground.sets[face.set].traits.flowing)
      for (int level = 0; level < ground.lattice_count(); ++level)
        close_nodes(ground.lattice(level), face.side, line_of(face, boundary.soil()[f].place), grid);
  }
  reactions_.clear();
  for (std::size_t f = 0; f < boundary.faces().size(); ++f) {
    const BoundaryFace& face = boundary.faces()[f];
    if (!ground.sets[face.set].traits.flowing)
      continue;
    const double load = -face.length * boundary.soil()[f].excess;
    const Vector n = face.ground.normal;
    for (const auto& [node, w] : boundary.weights(f)) {
      const Vector force{load * w * n.x * grid.open_x[node], load * w * n.y * grid.open_y[node]};
      if (force.x == 0.0 && force.y == 0.0)
        continue;
      grid.water_force_x[node] += force.x;
      grid.water_force_y[node] += force.y;
      reactions_.push_back({node, force});
    }
  }
}

double ImperviousFaces::open(Ground& ground) {
  Grid& grid = ground.grid;
  const double density = ground.spec.water->fluid.density;
  double power = 0.0;
  for (const auto& [n, force] : reactions_) {
    grid.water_force_x[n] -= force.x;
    grid.water_force_y[n] -= force.y;
    const double wet = grid.wet_volume[n];
    const double pores = wet > 0.0 ? grid.water_mass[n] / (density * wet) : 0.0;
    power += 0.5 * pores *
             (force.x * (grid.wx_before[n] - grid.vx_before[n] + grid.wx_after[n] - grid.vx_after[n]) +
              force.y * (grid.wy_before[n] - grid.vy_before[n] + grid.wy_after[n] - grid.vy_after[n]));
  }
  return power;
}

} // namespace tremolo::mpm_domain
