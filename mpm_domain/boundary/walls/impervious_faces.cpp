#include "mpm_domain/boundary/walls/impervious_faces.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/ranks/exact_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace tremolo::mpm_domain {

namespace {

/// Reaction of the walls on the pore water at a node.
struct Reaction {
  std::size_t node;
  Vector force; ///< N/m
};

using Reactions = std::vector<Reaction>;

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

/// Shares a force (N/m) on the water out among nodes, in the directions in which it can flow.
void push(Grid& grid, std::span<const FaceWeight> weights, Vector force, Reactions& reactions) {
  for (const auto& [node, w] : weights) {
    const Vector share{w * force.x * grid.open_x[node], w * force.y * grid.open_y[node]};
    if (share.x == 0.0 && share.y == 0.0)
      continue;
    grid.water_force_x[node] += share.x;
    grid.water_force_y[node] += share.y;
    reactions.push_back({node, share});
  }
}

/// Closes the nodes of the base, and adds the reactions of the faces to the forces on water.
void close(Ground& ground, const Boundary& boundary, Reactions& reactions) {
  Grid& grid = ground.grid;
  for_group(grid, NodeGroup::openness, [&](NodeField& open) {
    for (const auto& [begin, end] : ground.soil_rows)
      std::fill(open.data() + begin, open.data() + end, 1.0);
  });
  for (const std::size_t f : boundary.near_faces().all()) {
    const BoundaryFace& face = boundary.faces()[f];
    if (face.side == Side::base && ground.sets[face.set].traits.flowing)
      for (int level = 0; level < ground.lattice_count(); ++level)
        close_nodes(ground.lattice(level), line_of(face, boundary.soil()[f].position), grid);
  }
  if (const RigidBase* const table = boundary.supports().find<RigidBase>())
    table->close_to_water(grid);
  reactions.clear();
  for (const std::size_t f : boundary.near_faces().all()) {
    const BoundaryFace& face = boundary.faces()[f];
    const double load = -face.length * boundary.soil()[f].excess;
    if (ground.sets[face.set].traits.flowing)
      push(grid, boundary.weights(f), load * face.ground.normal, reactions);
  }
  const LeaningSides& lean = boundary.lean();
  for (std::size_t e = 0; e < lean.edges().size(); ++e)
    push(grid, lean.weights()[e], {0.0, lean.edges()[e].on_water}, reactions);
}

/// Takes the reactions off again.
/// @param kick  time that they have acted for, s
/// @returns their work on the flow n w at the nodes that count on this rank, J/m
ExactSums<1> open(Ground& ground, const Reactions& reactions, double kick) {
  Grid& grid = ground.grid;
  const double density = ground.spec.water->fluid.density;
  ExactSums<1> work;
  for (const auto& [n, force] : reactions) {
    grid.water_force_x[n] -= force.x;
    grid.water_force_y[n] -= force.y;
    const double wet = grid.wet_volume[n];
    const double pores = wet > 0.0 ? grid.water_mass[n] / (density * wet) : 0.0;
    if (ground.counts({n, n + 1}))
      work[0].add(0.5 * kick * pores *
                  (force.x * (grid.wx_before[n] - grid.vx_before[n] + grid.wx_after[n] - grid.vx_after[n]) +
                   force.y * (grid.wy_before[n] - grid.vy_before[n] + grid.wy_after[n] - grid.vy_after[n])));
  }
  return work;
}

} // namespace

std::vector<Pass> wall_passes(Ground& ground, const Boundary& boundary) {
  if (!ground.has_flow())
    return {};
  const auto reactions = std::make_shared<Reactions>();
  return {
      {Phase::forces, "", [&ground, &boundary, reactions](Step&) { close(ground, boundary, *reactions); }},
      {Phase::books, "", [&ground, reactions](Step& step) {
         step.bookings.add(
             open(ground, *reactions, step.kicks.front()),
             [&energy = step.energy](const std::array<double, 1>& work) { energy.input += work[0]; });
       }}};
}

} // namespace tremolo::mpm_domain
