#include "mpm_domain/grid_update.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

namespace {

/// Runs `row_sum(row)` for all rows and adds the results in order of the rows, for the same bits with any
/// thread count.
template <typename Sum, typename RowSum>
std::vector<Sum> over_rows(Domain& domain, const RowSum& row_sum) {
  std::vector<Sum> sums(static_cast<std::size_t>(domain.grid.ny));
  domain.workers.run(sums.size(), [&](std::size_t row) { sums[row] = row_sum(row); });
  return sums;
}

} // namespace

double grid_velocities(Domain& domain) {
  Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  const auto width = static_cast<std::size_t>(grid.nx);
  const std::vector<double> sums = over_rows<double>(domain, [&](std::size_t row) {
    double kinetic = 0.0;
    for (std::size_t n = row * width; n < (row + 1) * width; ++n) {
      const Lanes m = grid.sums[n].motion;
      const bool full = m[0] > empty;
      const double vx = full ? m[1] / m[0] : 0.0;
      const double vy = full ? m[2] / m[0] : 0.0;
      grid.motion[n].velocity = Lanes{vx, vy, vx, vy};
      kinetic += 0.5 * m[0] * (vx * vx + vy * vy);
    }
    return kinetic;
  });
  double kinetic = 0.0;
  for (const double sum : sums)
    kinetic += sum;
  return kinetic;
}

void remap_velocities(Domain& domain) {
  Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  const auto width = static_cast<std::size_t>(grid.nx);
  domain.workers.run(static_cast<std::size_t>(grid.ny), [&](std::size_t row) {
    for (std::size_t n = row * width; n < (row + 1) * width; ++n) {
      const Lanes m = grid.sums[n].motion;
      const Lanes v = grid.motion[n].velocity;
      const bool full = m[0] > empty;
      grid.motion[n].velocity = Lanes{full ? m[1] / m[0] : 0.0, full ? m[2] / m[0] : 0.0, v[2], v[3]};
    }
  });
}

GridUpdate update_grid(Domain& domain, double dt) {
  Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  const double gravity = domain.spec.gravity;
  const auto width = static_cast<std::size_t>(grid.nx);
  const std::vector<GridUpdate> sums = over_rows<GridUpdate>(domain, [&](std::size_t row) {
    GridUpdate sum;
    for (std::size_t n = row * width; n < (row + 1) * width; ++n) {
      const double m = grid.sums[n].motion[0];
      grid.acceleration[n] = {};
      if (m <= empty)
        continue;
      const Lanes f = grid.sums[n].force;
      const Lanes v = grid.motion[n].velocity;
      const double ax = f[0] / (m + 0.5 * dt * f[2]);
      const double ay = f[1] / (m + 0.5 * dt * f[3]);
      grid.acceleration[n] = {ax, ay};
      const double ux = v[0] + dt * ax;
      const double uy = v[1] + dt * ay;
      grid.motion[n].velocity = Lanes{v[0], v[1], ux, uy};
      const double mid_x = v[0] + 0.5 * dt * ax;
      const double mid_y = v[1] + 0.5 * dt * ay;
      sum.kinetic += 0.5 * m * (ux * ux + uy * uy);
      sum.gravity_work -= dt * m * gravity * mid_y;
      sum.dashpot_relief -= 0.5 * dt * dt * (f[2] * ax * mid_x + f[3] * ay * mid_y);
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
      const Lanes node = domain.grid.motion[weight.node].velocity;
      v[f].x += weight.w * node[0];
      v[f].y += weight.w * node[1];
    }
  }
}

void face_mid_velocities(const Domain& domain, std::span<const FaceWeights> weights, std::span<Vector> v) {
  for (std::size_t f = 0; f < weights.size(); ++f) {
    v[f] = {};
    for (const FaceWeight& weight : weights[f]) {
      const Lanes node = domain.grid.motion[weight.node].velocity;
      v[f].x += 0.5 * weight.w * (node[0] + node[2]);
      v[f].y += 0.5 * weight.w * (node[1] + node[3]);
    }
  }
}

void spread_tractions(Domain& domain, std::span<const FaceWeights> weights,
                      std::span<const Vector> tractions) {
  for (std::size_t f = 0; f < weights.size(); ++f) {
    const BoundaryFace& face = domain.faces[f];
    const Vector n = face.face.normal;
    // Diagonal of the dashpot matrix rho c_p n n^T + rho c_s t t^T.
    const double zx = face.face.impedance_p * n.x * n.x + face.face.impedance_s * n.y * n.y;
    const double zy = face.face.impedance_p * n.y * n.y + face.face.impedance_s * n.x * n.x;
    const Lanes t = face.length * Lanes{tractions[f].x, tractions[f].y, zx, zy};
    for (const FaceWeight& weight : weights[f])
      domain.grid.sums[weight.node].force += weight.w * t;
  }
}

} // namespace tremolo::mpm_domain
