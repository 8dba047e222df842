#include "mpm_domain/consistent_dashpots.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

/// Nodes from former steps may stay: no face gives them a force.
void ConsistentDashpots::find_nodes(const Domain& domain, std::span<const FaceWeights> weights) {
  if (known_.size() != domain.grid.size()) {
    nodes_.clear();
    known_.assign(domain.grid.size(), 0);
    a_.assign(domain.grid.size(), {});
    g_.assign(domain.grid.size(), {});
  }
  const std::size_t before = nodes_.size();
  for (const FaceWeights& face : weights)
    for (const auto& [node, w] : face)
      if (known_[node] == 0) {
        known_[node] = 1;
        nodes_.push_back(node);
      }
  if (nodes_.size() > before)
    std::ranges::sort(nodes_);
}

void ConsistentDashpots::find_accelerations(const Domain& domain, double dt) {
  const Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  for (const std::size_t n : nodes_) {
    a_[n] = {};
    if (grid.mass[n] > empty)
      a_[n] = {(grid.force_x[n] + g_[n].x) / (grid.mass[n] + 0.5 * dt * grid.dashpot_x[n]),
               (grid.force_y[n] + g_[n].y) / (grid.mass[n] + 0.5 * dt * grid.dashpot_y[n])};
  }
}

void ConsistentDashpots::find_forces(const Domain& domain, std::span<const FaceWeights> weights, double dt) {
  for (const std::size_t n : nodes_)
    g_[n] = {};
  for (std::size_t f = 0; f < weights.size(); ++f) {
    const Vector z = dashpots(domain.faces[f]);
    const double share = 0.5 * dt * domain.faces[f].length;
    Vector mean;
    for (const auto& [n, w] : weights[f])
      mean = {mean.x + w * a_[n].x, mean.y + w * a_[n].y};
    for (const auto& [n, w] : weights[f])
      g_[n] = {g_[n].x + w * share * z.x * (a_[n].x - mean.x),
               g_[n].y + w * share * z.y * (a_[n].y - mean.y)};
  }
}

void ConsistentDashpots::correct(Domain& domain, std::span<const FaceWeights> weights, double dt) {
  constexpr int steps = 3;
  find_nodes(domain, weights);
  for (const std::size_t n : nodes_)
    g_[n] = {};
  for (int k = 0; k < steps; ++k) {
    find_accelerations(domain, dt);
    find_forces(domain, weights, dt);
  }
  for (const std::size_t n : nodes_) {
    domain.grid.force_x[n] += g_[n].x;
    domain.grid.force_y[n] += g_[n].y;
  }
}

double ConsistentDashpots::power(const NodeField& vx, const NodeField& vy) const {
  double sum = 0.0;
  for (const std::size_t n : nodes_)
    sum += g_[n].x * vx[n] + g_[n].y * vy[n];
  return sum;
}

} // namespace tremolo::mpm_domain
