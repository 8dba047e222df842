#include "mpm_domain/consistent_dashpots.hpp"

#include <algorithm>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

constexpr std::size_t untouched = std::numeric_limits<std::size_t>::max();

} // namespace

void ConsistentDashpots::collect(const Domain& domain, std::span<const FaceWeights> weights, double dt) {
  for (const std::size_t node : nodes_)
    place_[node] = untouched;
  place_.resize(domain.grid.size(), untouched);
  nodes_.clear();
  entries_.clear();
  dashpots_.clear();
  for (std::size_t f = 0; f < weights.size(); ++f) {
    const BoundaryFace& face = domain.faces[f];
    const Vector z = dashpots(face);
    if (z.x == 0.0 && z.y == 0.0)
      continue;
    for (const auto& [node, w] : weights[f]) {
      if (place_[node] == untouched) {
        place_[node] = nodes_.size();
        nodes_.push_back(node);
      }
      entries_.push_back({place_[node], w});
    }
    const double share = 0.5 * dt * face.length;
    dashpots_.push_back({share * z.x, share * z.y, entries_.size()});
  }
  a_.resize(nodes_.size());
  g_.assign(nodes_.size(), {});
}

void ConsistentDashpots::find_accelerations(const Domain& domain, double dt) {
  const Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::size_t n = nodes_[i];
    a_[i] = {};
    if (grid.mass[n] > empty)
      a_[i] = {(grid.force_x[n] + g_[i].x) / (grid.mass[n] + 0.5 * dt * grid.dashpot_x[n]),
               (grid.force_y[n] + g_[i].y) / (grid.mass[n] + 0.5 * dt * grid.dashpot_y[n])};
  }
}

void ConsistentDashpots::find_forces() {
  std::ranges::fill(g_, Vector{});
  std::size_t begin = 0;
  for (const Dashpot& dashpot : dashpots_) {
    const std::span face = std::span(entries_).subspan(begin, dashpot.end - begin);
    begin = dashpot.end;
    Vector mean;
    for (const auto& [i, w] : face)
      mean = {mean.x + w * a_[i].x, mean.y + w * a_[i].y};
    for (const auto& [i, w] : face)
      g_[i] = {g_[i].x + w * dashpot.x * (a_[i].x - mean.x), g_[i].y + w * dashpot.y * (a_[i].y - mean.y)};
  }
}

void ConsistentDashpots::correct(Domain& domain, std::span<const FaceWeights> weights, double dt) {
  constexpr int steps = 3;
  collect(domain, weights, dt);
  for (int k = 0; k < steps; ++k) {
    find_accelerations(domain, dt);
    find_forces();
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    domain.grid.force_x[nodes_[i]] += g_[i].x;
    domain.grid.force_y[nodes_[i]] += g_[i].y;
  }
}

double ConsistentDashpots::power(const NodeField& vx, const NodeField& vy) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    sum += g_[i].x * vx[nodes_[i]] + g_[i].y * vy[nodes_[i]];
  return sum;
}

} // namespace tremolo::mpm_domain
