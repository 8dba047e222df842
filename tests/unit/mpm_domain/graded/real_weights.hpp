#pragma once

// Weights of real nodes on a mesh of three levels with outer and re-entrant corners, by the library's basis
// and by the naive one.

#include "mpm_domain/grid/box_average.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

namespace tremolo::mpm_domain::test {

/// `virtual_nodes` is the library's basis. `naive` is the plain bilinear one on every leaf: a hanging node is
/// seen by the fine side alone, so that the basis does not conform.
enum class Basis { virtual_nodes, naive };

struct RealWeight {
  double x = 0.0; ///< place of the node, m
  double y = 0.0;
  double s = 0.0;
  double gx = 0.0;
  double gy = 0.0;
};

using RealWeights = std::map<std::size_t, RealWeight>;

/// 8 m x 8 m of 1 m cells; an L of half-metre cells, and of quarter-metre cells in its corner.
inline GradedMesh l_shaped_mesh() {
  const std::vector<mesh::Refinement> boxes{
      {{2.0, 2.0, 6.0, 4.0}, 1}, {{2.0, 4.0, 4.0, 6.0}, 1}, {{2.5, 2.5, 3.5, 3.5}, 2}};
  return GradedMesh({.h = 1.0, .nx = 8, .ny = 8}, boxes);
}

inline void position(const GradedMesh& mesh, std::size_t node, RealWeight& weight) {
  for (const Lattice& lattice : mesh.lattices())
    if (node >= lattice.first && node < lattice.first + lattice.count()) {
      const std::size_t n = node - lattice.first;
      weight.x = lattice.x0 + lattice.h * static_cast<double>(n % static_cast<std::size_t>(lattice.nx));
      weight.y = lattice.y0 + lattice.h * static_cast<double>(n / static_cast<std::size_t>(lattice.nx));
    }
}

/// The naive basis' weights of lattice nodes.
inline std::vector<BoxWeight> naive_average(const GradedMesh& mesh, const mesh::Rectangle& box) {
  std::vector<BoxWeight> weights;
  for (const mesh::Cell& leaf : mesh.tree().leaves()) {
    const mesh::Rectangle all = mesh.tree().rectangle(leaf);
    const mesh::Rectangle part{std::max(all.x_min, box.x_min), std::max(all.y_min, box.y_min),
                               std::min(all.x_max, box.x_max), std::min(all.y_max, box.y_max)};
    const bool point = box.x_min == box.x_max && part.x_min >= part.x_max && part.x_max < all.x_max &&
                       part.y_max < all.y_max && part.x_min == part.x_max && part.y_min == part.y_max;
    if (!point && !(part.x_min < part.x_max && part.y_min < part.y_max))
      continue;
    const double share = point ? 1.0 : part.area() / box.area();
    const double h = mesh.tree().size(leaf.level);
    const double xi = (0.5 * (part.x_min + part.x_max) - all.x_min) / h;
    const double eta = (0.5 * (part.y_min + part.y_max) - all.y_min) / h;
    const int finer = is_split(mesh.tree(), leaf) ? 1 : 0; // the lattice that holds its corners
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) {
        const double nx = a ? xi : 1.0 - xi;
        const double ny = b ? eta : 1.0 - eta;
        weights.push_back({mesh.node(leaf.level + finer, (leaf.i + a) << finer, (leaf.j + b) << finer), 0.0,
                           0.0, share * nx * ny, share * (a ? ny : -ny) / h, share * (b ? nx : -nx) / h});
      }
  }
  return weights;
}

inline RealWeights real_weights(const GradedMesh& mesh, const mesh::Rectangle& box,
                                Basis basis = Basis::virtual_nodes) {
  static const auto row_of = [](const GradedMesh& m, std::size_t node) {
    for (std::size_t r = 0; r < m.prolongation().tied_count(); ++r)
      if (m.prolongation().tied(r) == node)
        return static_cast<std::ptrdiff_t>(r);
    return std::ptrdiff_t{-1};
  };
  std::vector<BoxWeight> weights;
  if (basis == Basis::naive)
    weights = naive_average(mesh, box);
  else
    box_average(mesh, box, weights);
  RealWeights real;
  const auto add = [&](std::size_t node, double share, const BoxWeight& w) {
    RealWeight& sum = real[node];
    position(mesh, node, sum);
    sum.s += share * w.s;
    sum.gx += share * w.gx;
    sum.gy += share * w.gy;
  };
  for (const BoxWeight& w : weights) {
    const std::ptrdiff_t row = row_of(mesh, w.node);
    if (row < 0)
      add(w.node, 1.0, w);
    else
      for (const Share& share : mesh.prolongation().row(static_cast<std::size_t>(row)))
        add(share.node, share.weight, w);
  }
  return real;
}

inline mesh::Rectangle box_at(double x, double y, double l) {
  return {x - l, y - l, x + l, y + l};
}

/// A particle's place and half size, m.
struct Particle {
  double x;
  double y;
  double l;
};

/// 300 particles over the refined region and its surroundings, of half sizes 0.06 to 0.8 root cells.
inline std::vector<Particle> random_particles() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(1.2, 6.8);
  std::uniform_real_distribution<double> half(0.06, 0.8);
  std::vector<Particle> particles;
  for (int n = 0; n < 300; ++n) {
    const double x = at(random);
    const double y = at(random);
    particles.push_back({x, y, half(random)});
  }
  return particles;
}

} // namespace tremolo::mpm_domain::test
