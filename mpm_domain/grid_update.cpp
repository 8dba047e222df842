#include "mpm_domain/grid_update.hpp"

#include "mpm_domain/tied_nodes.hpp"

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

std::vector<NodeRange> all_rows(const Domain& domain) {
  std::vector<NodeRange> rows;
  for (std::size_t row = 0; row < domain.row_count(); ++row)
    rows.push_back(domain.row(row));
  return rows;
}

} // namespace

double grid_velocities(Domain& domain) {
  const double kinetic = grid_velocities(domain, all_rows(domain));
  if (domain.has_tied_nodes())
    copy_to_tied(domain);
  return kinetic;
}

double grid_velocities(Domain& domain, std::span<const NodeRange> rows) {
  Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  const std::vector<double> sums = over_rows<double>(domain, rows, [&](const NodeRange& nodes) {
    double kinetic = 0.0;
    for (std::size_t n = nodes.begin; n < nodes.end; ++n) {
      const double m = grid.mass[n];
      const bool full = m > empty;
      const double vx = full ? grid.momentum_x[n] / m : 0.0;
      const double vy = full ? grid.momentum_y[n] / m : 0.0;
      grid.vx[n] = grid.vx_new[n] = vx;
      grid.vy[n] = grid.vy_new[n] = vy;
      kinetic += 0.5 * m * (vx * vx + vy * vy);
    }
    return kinetic;
  });
  double kinetic = 0.0;
  for (const double sum : sums)
    kinetic += sum;
  return kinetic;
}

double remap_velocities(Domain& domain) {
  const double power = remap_velocities(domain, all_rows(domain));
  if (domain.has_tied_nodes())
    copy_to_tied(domain);
  return power;
}

double remap_velocities(Domain& domain, std::span<const NodeRange> rows) {
  Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  const double gravity = domain.spec.gravity;
  const std::vector<double> sums = over_rows<double>(domain, rows, [&](const NodeRange& nodes) {
    double power = 0.0;
    for (std::size_t n = nodes.begin; n < nodes.end; ++n) {
      const double m = grid.mass[n];
      const bool full = m > empty;
      grid.vx[n] = full ? grid.momentum_x[n] / m : 0.0;
      grid.vy[n] = full ? grid.momentum_y[n] / m : 0.0;
      power += grid.force_x[n] * (grid.vx_new[n] - grid.vx[n]) +
               (grid.force_y[n] + m * gravity) * (grid.vy_new[n] - grid.vy[n]);
    }
    return power;
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

GridUpdate update_grid(Domain& domain, double dt) {
  const GridUpdate update = update_grid(domain, dt, all_rows(domain));
  if (domain.has_tied_nodes())
    copy_to_tied(domain);
  return update;
}

GridUpdate update_grid(Domain& domain, double dt, std::span<const NodeRange> rows) {
  Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  const double gravity = domain.spec.gravity;
  const std::vector<GridUpdate> sums = over_rows<GridUpdate>(domain, rows, [&](const NodeRange& nodes) {
    GridUpdate sum;
    for (std::size_t n = nodes.begin; n < nodes.end; ++n) {
      const double m = grid.mass[n];
      grid.acceleration[n] = {};
      if (m <= empty)
        continue;
      const Vector v = grid.velocity(n);
      const Vector dashpot = {grid.dashpot_x[n], grid.dashpot_y[n]};
      const double ax = grid.force_x[n] / (m + 0.5 * dt * dashpot.x);
      const double ay = grid.force_y[n] / (m + 0.5 * dt * dashpot.y);
      grid.acceleration[n] = {ax, ay};
      const double ux = grid.vx_new[n] = v.x + dt * ax;
      const double uy = grid.vy_new[n] = v.y + dt * ay;
      const double mid_x = v.x + 0.5 * dt * ax;
      const double mid_y = v.y + 0.5 * dt * ay;
      sum.kinetic += 0.5 * m * (ux * ux + uy * uy);
      sum.gravity_work -= dt * m * gravity * mid_y;
      sum.dashpot_relief -= 0.5 * dt * dt * (dashpot.x * ax * mid_x + dashpot.y * ay * mid_y);
    }
    return sum;
  });
  GridUpdate total;
  for (const GridUpdate& sum : sums) {
    total.kinetic += sum.kinetic;
    total.gravity_work += sum.gravity_work;
    total.dashpot_relief += sum.dashpot_relief;
  }
  return total;
}

void face_velocities(const Domain& domain, std::span<const FaceWeights> weights, std::span<Vector> v) {
  for (std::size_t f = 0; f < weights.size(); ++f) {
    v[f] = {};
    for (const FaceWeight& weight : weights[f]) {
      const Vector node = domain.grid.velocity(weight.node);
      v[f].x += weight.w * node.x;
      v[f].y += weight.w * node.y;
    }
  }
}

void face_mid_velocities(const Domain& domain, std::span<const FaceWeights> weights, std::span<Vector> v) {
  for (std::size_t f = 0; f < weights.size(); ++f) {
    v[f] = {};
    for (const FaceWeight& weight : weights[f]) {
      const Vector before = domain.grid.velocity(weight.node);
      const Vector after = domain.grid.new_velocity(weight.node);
      v[f].x += 0.5 * weight.w * (before.x + after.x);
      v[f].y += 0.5 * weight.w * (before.y + after.y);
    }
  }
}

void spread_tractions(Domain& domain, std::span<const FaceWeights> weights,
                      std::span<const Vector> tractions) {
  for (std::size_t f = 0; f < weights.size(); ++f) {
    const BoundaryFace& face = domain.faces[f];
    const Vector z = dashpots(face);
    Grid& grid = domain.grid;
    for (const auto& [node, w] : weights[f]) {
      const double share = w * face.length;
      grid.force_x[node] += share * tractions[f].x;
      grid.force_y[node] += share * tractions[f].y;
      grid.dashpot_x[node] += share * z.x;
      grid.dashpot_y[node] += share * z.y;
    }
  }
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
