#include "mpm_domain/boundary/consistent_dashpots.hpp"

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

/// 1/(m + dt/2 C_L) of the nodes that faces touch; zero where they are empty. Water moves with its soil here.
void ConsistentDashpots::find_inertia(const Grid& grid, const NodeField& dashpot, double empty, double dt,
                                      Component& c) const {
  const bool flows = grid.traits.flowing;
  for (const std::size_t n : nodes_->all()) {
    const double mass = flows ? grid.mass[n] + grid.water_mass[n] : grid.mass[n];
    c.per_inertia[n] = grid.mass[n] > empty ? 1.0 / (mass + 0.5 * dt * dashpot[n]) : 0.0;
  }
}

/// One fixed-point step: computes a from g, then g from a.
/// @param dashpots  L Z dt/2 of each face
void ConsistentDashpots::iterate(const NodeField& force, std::span<const std::size_t> which,
                                 std::span<const FaceWeights> weights, std::span<const double> dashpots,
                                 Component& c) const {
  for (const std::size_t n : nodes_->all()) {
    c.a[n] = (force[n] + c.g[n]) * c.per_inertia[n];
    c.g[n] = 0.0;
  }
  for (const std::size_t f : which) {
    const double z = dashpots[f];
    double mean = 0.0;
    for (const auto& [n, w] : weights[f])
      mean += w * c.a[n];
    for (const auto& [n, w] : weights[f])
      c.g[n] += w * z * (c.a[n] - mean);
  }
}

void ConsistentDashpots::fit(std::size_t grid_size) {
  if (x_.g.size() == grid_size)
    return;
  for (Component* c : {&x_, &y_})
    for (NodeField* field : {&c->a, &c->g, &c->per_inertia})
      set_to_zeros(*field, grid_size);
}

void ConsistentDashpots::correct(Ground& ground, std::span<const BoundaryFace> faces,
                                 std::span<const std::size_t> which, std::span<const FaceWeights> weights,
                                 double dt) {
  constexpr int steps = 3;
  Grid& grid = ground.grid;
  for (Component* c : {&x_, &y_})
    c->of_faces.resize(faces.size());
  for (const std::size_t f : which) {
    const Vector z = dashpot_diagonal(faces[f]);
    const double share = 0.5 * dt * faces[f].length;
    x_.of_faces[f] = share * z.x;
    y_.of_faces[f] = share * z.y;
  }
  const double empty = empty_mass(ground);
  ground.workers.run(2, [&](std::size_t component) {
    const bool is_x = component == 0;
    Component& c = is_x ? x_ : y_;
    NodeField& force = is_x ? grid.force_x : grid.force_y;
    find_inertia(grid, is_x ? grid.dashpot_x : grid.dashpot_y, empty, dt, c);
    for (const std::size_t n : nodes_->all())
      c.g[n] = 0.0;
    for (int k = 0; k < steps; ++k)
      iterate(force, which, weights, c.of_faces, c);
    for (const std::size_t n : nodes_->all())
      force[n] += c.g[n];
  });
}

} // namespace tremolo::mpm_domain
