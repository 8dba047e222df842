#include "mpm_domain/boundary/consistent_dashpots.hpp"

#include "mpm_domain/domain.hpp"

namespace tremolo::mpm_domain {

void ConsistentDashpots::find_accelerations(const NodeField& mass, const NodeField& force,
                                            const NodeField& dashpot, double empty, double dt,
                                            Component& c) const {
  for (const std::size_t n : nodes_->all())
    c.a[n] = mass[n] > empty ? (force[n] + c.g[n]) / (mass[n] + 0.5 * dt * dashpot[n]) : 0.0;
}

/// @param dashpots  L Z dt/2 of each face
void ConsistentDashpots::find_forces(std::span<const FaceWeights> weights, std::span<const double> dashpots,
                                     Component& c) const {
  for (const std::size_t n : nodes_->all())
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
  Grid& grid = domain.grid;
  if (x_.g.size() != grid.size())
    for (Component* c : {&x_, &y_})
      for (NodeField* field : {&c->a, &c->g})
        field->assign(grid.size(), 0.0);
  const double empty = empty_mass(domain);
  domain.workers.run(2, [&](std::size_t component) {
    const bool is_x = component == 0;
    Component& c = is_x ? x_ : y_;
    NodeField& force = is_x ? grid.force_x : grid.force_y;
    const NodeField& dashpot = is_x ? grid.dashpot_x : grid.dashpot_y;
    std::vector<double> of_faces;
    for (const BoundaryFace& face : domain.boundary.faces())
      of_faces.push_back(0.5 * dt * face.length *
                         (is_x ? dashpot_diagonal(face).x : dashpot_diagonal(face).y));
    for (const std::size_t n : nodes_->all())
      c.g[n] = 0.0;
    for (int k = 0; k < steps; ++k) {
      find_accelerations(grid.mass, force, dashpot, empty, dt, c);
      find_forces(weights, of_faces, c);
    }
    for (const std::size_t n : nodes_->all())
      force[n] += c.g[n];
  });
}

double ConsistentDashpots::power(const NodeField& vx, const NodeField& vy) const {
  double sum = 0.0;
  for (const std::size_t n : nodes_->all())
    sum += x_.g[n] * vx[n] + y_.g[n] * vy[n];
  return sum;
}

} // namespace tremolo::mpm_domain
