#include "mpm_domain/boundary/consistent_dashpots.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

/// Nodes from former steps may stay: no face gives them a force.
void ConsistentDashpots::find_nodes(const Domain& domain, std::span<const FaceWeights> weights) {
  if (known_.size() != domain.grid.size()) {
    nodes_.clear();
    known_.assign(domain.grid.size(), 0);
    for (Component* c : {&x_, &y_})
      for (NodeField* field : {&c->a, &c->g})
        field->assign(domain.grid.size(), 0.0);
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

void ConsistentDashpots::find_accelerations(const NodeField& mass, const NodeField& force,
                                            const NodeField& dashpot, double empty, double dt,
                                            Component& c) const {
  for (const std::size_t n : nodes_)
    c.a[n] = mass[n] > empty ? (force[n] + c.g[n]) / (mass[n] + 0.5 * dt * dashpot[n]) : 0.0;
}

/// @param dashpots  L Z dt/2 of each face
void ConsistentDashpots::find_forces(std::span<const FaceWeights> weights, std::span<const double> dashpots,
                                     Component& c) const {
  for (const std::size_t n : nodes_)
    c.g[n] = 0.0;
  for (std::size_t f = 0; f < weights.size(); ++f) {
    double mean = 0.0;
    for (const auto& [n, w] : weights[f])
      mean += w * c.a[n];
    for (const auto& [n, w] : weights[f])
      c.g[n] += w * dashpots[f] * (c.a[n] - mean);
  }
}

void ConsistentDashpots::correct(Domain& domain, std::span<const FaceWeights> weights, double dt) {
  constexpr int steps = 3;
  find_nodes(domain, weights);
  Grid& grid = domain.grid;
  const double empty = empty_mass(domain);
  domain.workers.run(2, [&](std::size_t component) {
    const bool is_x = component == 0;
    Component& c = is_x ? x_ : y_;
    NodeField& force = is_x ? grid.force_x : grid.force_y;
    const NodeField& dashpot = is_x ? grid.dashpot_x : grid.dashpot_y;
    std::vector<double> of_faces;
    for (const BoundaryFace& face : domain.faces)
      of_faces.push_back(0.5 * dt * face.length * (is_x ? dashpots(face).x : dashpots(face).y));
    for (const std::size_t n : nodes_)
      c.g[n] = 0.0;
    for (int k = 0; k < steps; ++k) {
      find_accelerations(grid.mass, force, dashpot, empty, dt, c);
      find_forces(weights, of_faces, c);
    }
    for (const std::size_t n : nodes_)
      force[n] += c.g[n];
  });
}

double ConsistentDashpots::power(const NodeField& vx, const NodeField& vy) const {
  double sum = 0.0;
  for (const std::size_t n : nodes_)
    sum += x_.g[n] * vx[n] + y_.g[n] * vy[n];
  return sum;
}

} // namespace tremolo::mpm_domain
