#include "mpm_domain/prop/particle_nodes.hpp"

#include "mpm_domain/grid/box_average.hpp"
#include "mpm_domain/ground.hpp"
#include "mpm_domain/kernel/kernel.hpp"

#include <span>

namespace tremolo::mpm_domain {

namespace {

/// act(node, S) for the nodes of one lattice.
template <class Act>
void over_lattice(const Lattice& lattice, const Particles& set, std::size_t k, const Act& act) {
  const Vector half = half_sides(set, k);
  const Weights wx = cell_weights(set.x[k], {lattice.x0, lattice.h}, half.x);
  const Weights wy = cell_weights(set.y[k], {lattice.y0, lattice.h}, half.y);
  for (int b = 0; b < 4; ++b)
    for (int a = 0; a < 4; ++a)
      if (const double s = wx.s[a] * wy.s[b]; s != 0.0)
        act(lattice.index(wx.base + a, wy.base + b), s);
}

} // namespace

void add_nodes(const Ground& ground, std::size_t set, std::size_t k, double share,
               std::vector<NodeShare>& nodes) {
  const Particles& particles = ground.sets[set];
  if (particles.body) {
    over_lattice(ground.bodies[*particles.body].lattice, particles, k, [&](std::size_t node, double s) {
      nodes.push_back({node, share * s});
    });
    return;
  }
  const auto add = [&](std::size_t node, double s) {
    const std::span<const Share> followed = ground.ties().shares_of(node);
    if (followed.empty())
      nodes.push_back({node, share * s});
    for (const Share& one : followed)
      nodes.push_back({one.node, one.weight * share * s});
  };
  if (!ground.mesh) {
    over_lattice(ground.grid, particles, k, add);
    return;
  }
  std::vector<BoxWeight> weights;
  box_average(*ground.mesh, box_of(particles, k), weights);
  for (const BoxWeight& weight : weights)
    add(weight.node, weight.s);
}

} // namespace tremolo::mpm_domain
