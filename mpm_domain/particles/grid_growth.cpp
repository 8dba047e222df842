#include "mpm_domain/particles/grid_growth.hpp"

#include "mpm_domain/tiles/totals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace tremolo::mpm_domain {

namespace {

/// Cells by which the grid grows beyond what is asked of it, so that it seldom has to.
constexpr int spare_cells = 8;

/// More cells than a particle can go from one sort to the next, 0.9 + 0.65.
constexpr double jump_cells = 2.0;

/// NaN lies in no box.
bool contains(const Box& box, double x, double y) {
  return x >= box.x_min && x < box.x_max && y >= box.y_min && y < box.y_max;
}

Box widened(const Box& box, double by) {
  return {box.x_min - by, box.y_min - by, box.x_max + by, box.y_max + by};
}

/// The positions allowed for particles at a sort: all nodes that they touch until the next sort must lie on
/// the grid, and with reduced dispersion also the neighbours that differences need.
Box room_of(const Grid& grid) {
  const int more = grid.traits.sharp ? 2 : 0;
  return {grid.x0 + (2 + more) * grid.h, grid.y0 + (2 + more) * grid.h,
          grid.x0 + (grid.nx - 4 - more) * grid.h, grid.y0 + (grid.ny - 3 - more) * grid.h};
}

std::string particle_text(const Particles& p, std::size_t k, double time, long step) {
  return fmt::format("particle {} of soil '{}' at x = {:.6g} m, y = {:.6g} m, t = {:.6g} s, step {}", p.id[k],
                     p.soil, p.x[k], p.y[k], time, step);
}

void refuse_jump(const Box& room, const Particles& p, std::size_t k, double h, double time, long step) {
  if (!contains(widened(room, jump_cells * h), p.x[k], p.y[k]))
    throw std::runtime_error(fmt::format(
        "{} has jumped out of the grid, x {:.6g} to {:.6g} m, y {:.6g} to {:.6g} m, with a velocity of "
        "{:.3g}, {:.3g} m/s: the motion is not physical; look at the soil's stiffness and at the step",
        particle_text(p, k, time, step), room.x_min, room.x_max, room.y_min, room.y_max, p.vx[k], p.vy[k]));
}

void refuse_overflow(const Box& limits, const Particles& p, std::size_t k, double time, long step) {
  const auto refuse = [&](std::string_view side, std::string_view axis, double limit) {
    throw std::runtime_error(fmt::format(
        "{} has left the model over its {}: {} cells beyond the faces there, at {} = {:.6g} m, is the limit; "
        "a model that reaches farther holds this soil",
        particle_text(p, k, time, step), side, overflow_cells, axis, limit));
  };
  if (p.x[k] < limits.x_min)
    refuse("left side", "x", limits.x_min);
  if (p.x[k] >= limits.x_max)
    refuse("right side", "x", limits.x_max);
  if (p.y[k] < limits.y_min)
    refuse("base", "y", limits.y_min);
}

/// Cells to add at an end of the grid so that `missing` metres more find room.
int cells_for(double missing, double h) {
  return missing > 0.0 ? static_cast<int>(std::ceil(missing / h)) + spare_cells : 0;
}

} // namespace

Box over_ranks(const Ground& ground, const Box& box) {
  std::array<double, 4> outwards{-box.x_min, -box.y_min, box.x_max, box.y_max};
  take_largest(ground, outwards);
  return {-outwards[0], -outwards[1], outwards[2], outwards[3]};
}

double largest_grid(const Spec& spec) {
  const double cells = (spec.box.x_max - spec.box.x_min) * (spec.box.y_max - spec.box.y_min) /
                       (spec.cell_size * spec.cell_size);
  return std::max(1e6, 4.0 * cells);
}

void make_room(Ground& ground, const Box& limits, double time, long step) {
  Grid& grid = ground.grid;
  const double h = grid.h;
  const Box room = room_of(grid);
  const Box usual{std::max(room.x_min, limits.x_min), std::max(room.y_min, limits.y_min),
                  std::min(room.x_max, limits.x_max), std::min(room.y_max, limits.y_max)};
  Box needed = room;
  for (const Particles& p : ground.sets_of_soil()) // lattices of bodies follow these
    for (std::size_t k = 0; k < p.size(); ++k) {
      if (contains(usual, p.x[k], p.y[k]))
        continue;
      refuse_jump(room, p, k, h, time, step);
      refuse_overflow(limits, p, k, time, step);
      needed = {std::min(needed.x_min, p.x[k]), std::min(needed.y_min, p.y[k]),
                std::max(needed.x_max, p.x[k] + h), std::max(needed.y_max, p.y[k] + h)};
      const double nodes = ((needed.x_max - needed.x_min) / h + 6) * ((needed.y_max - needed.y_min) / h + 5);
      if (nodes > largest_grid(ground.spec))
        throw std::runtime_error(
            fmt::format("{} asks for a grid of {:.4g} nodes; the largest allowed is {:.4g}",
                        particle_text(p, k, time, step), nodes, largest_grid(ground.spec)));
    }
  needed = over_ranks(ground, needed);
  const int left = cells_for(room.x_min - needed.x_min, h);
  const int right = cells_for(needed.x_max - room.x_max, h);
  const int down = cells_for(room.y_min - needed.y_min, h);
  const int up = cells_for(needed.y_max - room.y_max, h);
  if (left + right + down + up == 0)
    return;
  grid.x0 -= left * h;
  grid.y0 -= down * h;
  resize(grid, grid.nx + left + right, grid.ny + down + up);
  rebuild_mesh(ground);
}

} // namespace tremolo::mpm_domain
