#include "mpm_domain/step/grid_update.hpp"

#include "mpm_domain/kernel/lanes.hpp"

namespace tremolo::mpm_domain {

namespace {

/// Velocities of four nodes.
struct Vectors {
  Lanes x, y;
};

/// p/m; zero where the mass m is that of an empty node.
template <typename Group>
Vectors velocities(const Grid& grid, std::size_t n, Group group, const Lanes& m, double empty) {
  const Lanes per_mass = inverse(m, m > empty);
  return {group.load(&grid.momentum_x[n]) * per_mass, group.load(&grid.momentum_y[n]) * per_mass};
}

} // namespace

ExactSums<1> grid_velocities(Ground& ground, std::span<const NodeRange> rows) {
  Grid& grid = ground.grid;
  const double empty = empty_mass(ground);
  return sum_over_rows<1>(ground, rows, [&](const NodeRange& nodes) {
    Lanes kinetic{};
    by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
      const Lanes m = group.load(&grid.mass[n]);
      const Vectors v = velocities(grid, n, group, m, empty);
      group.store(&grid.vx_before[n], v.x);
      group.store(&grid.vy_before[n], v.y);
      kinetic += 0.5 * m * (v.x * v.x + v.y * v.y);
    });
    return std::array{sum(kinetic)};
  });
}

ExactSums<1> remap_velocities(Ground& ground, std::span<const NodeRange> rows) {
  Grid& grid = ground.grid;
  const double empty = empty_mass(ground);
  const double gravity = ground.spec.gravity;
  return sum_over_rows<1>(ground, rows, [&](const NodeRange& nodes) {
    Lanes power{};
    by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
      const Lanes m = group.load(&grid.mass[n]);
      const Vectors u = velocities(grid, n, group, m, empty);
      group.store(&grid.vx_strain[n], u.x);
      group.store(&grid.vy_strain[n], u.y);
      power += group.load(&grid.force_x[n]) * (group.load(&grid.vx_after[n]) - u.x) +
               (group.load(&grid.force_y[n]) + m * gravity) * (group.load(&grid.vy_after[n]) - u.y);
    });
    return std::array{sum(power)};
  });
}

ExactSums<3> update_grid(Ground& ground, double dt, std::span<const NodeRange> rows) {
  Grid& grid = ground.grid;
  const double empty = empty_mass(ground);
  const double gravity = ground.spec.gravity;
  return sum_over_rows<3>(ground, rows, [&](const NodeRange& nodes) {
    Lanes kinetic{};
    Lanes weight_work{}; // of the weight per m/s2, downwards
    Lanes relief{};
    by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
      const Lanes m = group.load(&grid.mass[n]);
      const LaneMask full = m > empty;
      // One component; returns its mean velocity over the step.
      const auto kick = [&](const NodeField& force, const NodeField& dashpot, const NodeField& before,
                            NodeField& acceleration, NodeField& after) {
        const Lanes c = group.load(&dashpot[n]);
        const Lanes v = group.load(&before[n]);
        const Lanes inertia = choose(full, m + 0.5 * dt * c, all(1.0));
        const Lanes a = choose(full, group.load(&force[n]) / inertia, Lanes{});
        const Lanes u = v + dt * a;
        const Lanes mid = v + 0.5 * dt * a;
        group.store(&acceleration[n], a);
        group.store(&after[n], u);
        kinetic += 0.5 * m * u * u;
        relief -= c * a * mid;
        return mid;
      };
      kick(grid.force_x, grid.dashpot_x, grid.vx_before, grid.ax, grid.vx_after);
      weight_work -= m * kick(grid.force_y, grid.dashpot_y, grid.vy_before, grid.ay, grid.vy_after);
    });
    return std::array{sum(kinetic), dt * gravity * sum(weight_work), 0.5 * dt * dt * sum(relief)};
  });
}

} // namespace tremolo::mpm_domain
