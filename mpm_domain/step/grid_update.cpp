#include "mpm_domain/step/grid_update.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/lanes.hpp"

#include <algorithm>
#include <numeric>

namespace tremolo::mpm_domain {

namespace {

/// Runs `row_sum(nodes)` for all rows of nodes and adds the results in order of the rows, for the same bits
/// with any thread count.
template <typename Sum, typename RowSum>
std::vector<Sum> over_rows(Domain& domain, std::span<const NodeRange> rows, const RowSum& row_sum) {
  std::vector<Sum> sums(rows.size());
  domain.workers.run(sums.size(), [&](std::size_t row) { sums[row] = row_sum(rows[row]); });
  return sums;
}

/// Velocities of four nodes.
struct Vectors {
  Lanes x, y;
};

/// p/m; zero where the mass m is that of an empty node.
template <typename Group>
Vectors velocities(const Grid& grid, std::size_t n, Group group, const Lanes& m, double empty) {
  const LaneMask full = m > empty;
  const Lanes per_mass = choose(full, 1.0 / choose(full, m, all(1.0)), Lanes{});
  return {group.load(&grid.momentum_x[n]) * per_mass, group.load(&grid.momentum_y[n]) * per_mass};
}

} // namespace

double grid_velocities(Domain& domain) {
  const double kinetic = grid_velocities(domain, domain.soil_rows);
  if (domain.has_tied_nodes())
    copy_to_tied(domain, {&domain.grid.vx, &domain.grid.vy, &domain.grid.vx_new, &domain.grid.vy_new});
  return kinetic;
}

double grid_velocities(Domain& domain, std::span<const NodeRange> rows) {
  Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  const std::vector<double> sums = over_rows<double>(domain, rows, [&](const NodeRange& nodes) {
    Lanes kinetic{};
    by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
      const Lanes m = group.load(&grid.mass[n]);
      const Vectors v = velocities(grid, n, group, m, empty);
      for (NodeField* field : {&grid.vx, &grid.vx_new})
        group.store(&(*field)[n], v.x);
      for (NodeField* field : {&grid.vy, &grid.vy_new})
        group.store(&(*field)[n], v.y);
      kinetic += 0.5 * m * (v.x * v.x + v.y * v.y);
    });
    return sum(kinetic);
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double remap_velocities(Domain& domain) {
  const double power = remap_velocities(domain, domain.soil_rows);
  if (domain.has_tied_nodes())
    copy_to_tied(domain, {&domain.grid.vx, &domain.grid.vy});
  return power;
}

double remap_velocities(Domain& domain, std::span<const NodeRange> rows) {
  Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  const double gravity = domain.spec.gravity;
  const std::vector<double> sums = over_rows<double>(domain, rows, [&](const NodeRange& nodes) {
    Lanes power{};
    by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
      const Lanes m = group.load(&grid.mass[n]);
      const Vectors v = velocities(grid, n, group, m, empty);
      group.store(&grid.vx[n], v.x);
      group.store(&grid.vy[n], v.y);
      power += group.load(&grid.force_x[n]) * (group.load(&grid.vx_new[n]) - v.x) +
               (group.load(&grid.force_y[n]) + m * gravity) * (group.load(&grid.vy_new[n]) - v.y);
    });
    return sum(power);
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

GridUpdate update_grid(Domain& domain, double dt) {
  const GridUpdate update = update_grid(domain, dt, domain.soil_rows);
  if (domain.has_tied_nodes())
    copy_to_tied(domain, {&domain.grid.vx_new, &domain.grid.vy_new, &domain.grid.ax, &domain.grid.ay});
  return update;
}

GridUpdate update_grid(Domain& domain, double dt, std::span<const NodeRange> rows) {
  Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  const double gravity = domain.spec.gravity;
  const std::vector<GridUpdate> sums = over_rows<GridUpdate>(domain, rows, [&](const NodeRange& nodes) {
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
      kick(grid.force_x, grid.dashpot_x, grid.vx, grid.ax, grid.vx_new);
      weight_work -= m * kick(grid.force_y, grid.dashpot_y, grid.vy, grid.ay, grid.vy_new);
    });
    return GridUpdate{sum(kinetic), dt * gravity * sum(weight_work), 0.5 * dt * dt * sum(relief)};
  });
  GridUpdate total;
  for (const GridUpdate& sum : sums) {
    total.kinetic += sum.kinetic;
    total.gravity_work += sum.gravity_work;
    total.dashpot_relief += sum.dashpot_relief;
  }
  return total;
}

namespace {

/// v_f = sum_i W_if u_i of all faces, u(n) a velocity of node n.
template <typename NodeVelocity>
void read_faces(Domain& domain, std::span<const FaceWeights> weights, std::span<Vector> v,
                const NodeVelocity& u) {
  for_faces(domain.workers, weights.size(), [&](std::size_t f) {
    v[f] = {};
    for (const auto& [node, w] : weights[f]) {
      const Vector of_node = u(node);
      v[f].x += w * of_node.x;
      v[f].y += w * of_node.y;
    }
  });
}

} // namespace

void face_velocities(Domain& domain, std::span<const FaceWeights> weights, std::span<Vector> v) {
  read_faces(domain, weights, v, [&](std::size_t n) { return domain.grid.velocity(n); });
}

void face_mid_velocities(Domain& domain, std::span<const FaceWeights> weights, std::span<Vector> v) {
  read_faces(domain, weights, v, [&](std::size_t n) {
    const Vector before = domain.grid.velocity(n);
    const Vector after = domain.grid.new_velocity(n);
    return Vector{0.5 * (before.x + after.x), 0.5 * (before.y + after.y)};
  });
}

void spread_tractions(Domain& domain, std::span<const FaceWeights> weights,
                      std::span<const Vector> tractions) {
  Grid& grid = domain.grid;
  domain.workers.run(2, [&](std::size_t component) {
    const bool is_x = component == 0;
    NodeField& force = is_x ? grid.force_x : grid.force_y;
    NodeField& dashpot = is_x ? grid.dashpot_x : grid.dashpot_y;
    for (std::size_t f = 0; f < weights.size(); ++f) {
      const BoundaryFace& face = domain.faces[f];
      const double t = is_x ? tractions[f].x : tractions[f].y;
      const double z = is_x ? dashpots(face).x : dashpots(face).y;
      for (const auto& [node, w] : weights[f]) {
        const double share = w * face.length;
        force[node] += share * t;
        dashpot[node] += share * z;
      }
    }
  });
}

// A mass m_L that moves with the node adds m_L to m in (m + dt C/2) (v+ - v-) = dt f: it is a dashpot C = 2
// m_L/dt that is not in f.
void spread_layer_mass(Domain& domain, std::span<const FaceWeights> weights, double dt) {
  for (std::size_t f = 0; f < weights.size(); ++f) {
    const double lumped = 2.0 / dt * domain.faces[f].mass * domain.faces[f].length;
    for (const auto& [node, w] : weights[f]) {
      domain.grid.dashpot_x[node] += w * lumped;
      domain.grid.dashpot_y[node] += w * lumped;
    }
  }
}

} // namespace tremolo::mpm_domain
