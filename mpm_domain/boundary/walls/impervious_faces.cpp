#include "mpm_domain/boundary/walls/impervious_faces.hpp"

#include "mpm_domain/boundary/boundary.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// Closes the nodes of a lattice on the line of a face of the base, and those next to it outside.
void close_nodes(const Lattice& lattice, const mesh::Rectangle& line, Grid& grid) {
  const int row = static_cast<int>(std::lround((line.y_min - lattice.y0) / lattice.h));
  const int first = static_cast<int>(std::floor((line.x_min - lattice.x0) / lattice.h + 1e-9));
  const int last = static_cast<int>(std::ceil((line.x_max - lattice.x0) / lattice.h - 1e-9));
  for (int i = first; i <= last; ++i)
    for (const int j : {row, row - 1})
      if (i >= 0 && i < lattice.nx && j >= 0 && j < lattice.ny)
        grid.open_y[lattice.index(i, j)] = 0.0;
}

} // namespace

void ImperviousFaces::close(Ground& ground, const Boundary& boundary) {
  Grid& grid = ground.grid;
  for_group(grid, NodeGroup::openness, [](NodeField& open) { std::ranges::fill(open, 1.0); });
  for (std::size_t f = 0; f < boundary.faces().size(); ++f) {
    const BoundaryFace& face = boundary.faces()[f];
    if (face.side == Side::base && ground.sets[face.set].traits.flowing)
      for (int level = 0; level < ground.lattice_count(); ++level)
        close_nodes(ground.lattice(level), line_of(face, boundary.soil()[f].place), grid);
  }
  reactions_.clear();
  for (std::size_t f = 0; f < boundary.faces().size(); ++f) {
    const BoundaryFace& face = boundary.faces()[f];
    const double load = -face.length * boundary.soil()[f].excess;
    if (ground.sets[face.set].traits.flowing)
      push(grid, boundary.weights(f), {load * face.ground.normal.x, load * face.ground.normal.y});
  }
  const LeaningSides& lean = boundary.lean();
  for (std::size_t e = 0; e < lean.edges().size(); ++e)
    push(grid, lean.weights()[e], {0.0, lean.edges()[e].on_water});
}

/// Shares a force (N/m) on the water out among nodes, in the directions in which it can flow.
void ImperviousFaces::push(Grid& grid, std::span<const FaceWeight> weights, Vector force) {
  for (const auto& [node, w] : weights) {
    const Vector share{w * force.x * grid.open_x[node], w * force.y * grid.open_y[node]};
    if (share.x == 0.0 && share.y == 0.0)
      continue;
    grid.water_force_x[node] += share.x;
    grid.water_force_y[node] += share.y;
    reactions_.push_back({node, share});
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
