// Random waves between fixed walls, in soil under a uniform pressure, cross the level interfaces a hundred
// times. Particles stay in place: what happens is the basis' doing alone. A basis that does not conform has
// net forces under the pressure, which never come to rest.

#include "tests/support/hard_case.hpp"
#include "tests/unit/mpm_domain/graded/real_weights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace tremolo::mpm_domain {
namespace {

using test::Basis;

constexpr double density = 1700.0;                      // kg/m3
constexpr double modulus = 40e6 * 0.72 / (1.28 * 0.44); // of P waves, Pa
constexpr double lame = 40e6 * 0.28 / (1.28 * 0.44);    // Pa
constexpr double shear = 40e6 / (2.0 * 1.28);           // Pa
constexpr double pressure = 1e5;                        // Pa
constexpr double side = 8.0;                            // of the mesh, m

struct Node {
  double mass = 0.0;
  double vx = 0.0, vy = 0.0, fx = 0.0, fy = 0.0;
  bool fixed = false;
};

struct Point {
  double area = 0.0;
  double sxx = -pressure, syy = -pressure, sxy = 0.0;
  std::vector<std::pair<std::size_t, test::RealWeight>> weights;
};

/// Small strains on the l-shaped mesh, 2 x 2 particles a cell.
class TrappedWaves {
public:
  explicit TrappedWaves(Basis basis) {
    const GradedMesh mesh = test::l_shaped_mesh();
    finest_ = mesh.tree().size(mesh.tree().finest());
    std::map<std::size_t, std::size_t> positions;
    for (const mesh::Cell& leaf : mesh.tree().leaves()) {
      const mesh::Rectangle cell = mesh.tree().rectangle(leaf);
      const double l = 0.25 * mesh.tree().size(leaf.level);
      for (const double a : {1.0, 3.0})
        for (const double b : {1.0, 3.0})
          add(mesh, test::box_at(cell.x_min + a * l, cell.y_min + b * l, l), basis, positions);
    }
    set_velocities();
  }

  /// Largest kinetic energy on the way over that at the start, when all energy of the waves is kinetic.
  double run(double crossings) {
    const double dt = 0.5 * finest_ / std::sqrt(modulus / density);
    const double start = kinetic();
    double largest = 0.0;
    const auto steps = static_cast<long>(crossings * side / std::sqrt(modulus / density) / dt);
    for (long step = 0; step < steps; ++step) {
      move(dt);
      strain(dt);
      largest = std::max(largest, kinetic());
    }
    return largest / start;
  }

private:
  void add(const GradedMesh& mesh, const mesh::Rectangle& box, Basis basis,
           std::map<std::size_t, std::size_t>& positions) {
    Point& point = points_.emplace_back();
    point.area = box.area();
    for (const auto& [node, w] : test::real_weights(mesh, box, basis)) {
      const auto [position, is_new] = positions.try_emplace(node, nodes_.size());
      if (is_new) {
        const auto inside = [](double a) { return a > 1e-9 && a < side - 1e-9; };
        nodes_.push_back({.fixed = !inside(w.x) || !inside(w.y)});
        at_.push_back({w.x, w.y});
      }
      nodes_[position->second].mass += w.s * density * point.area;
      point.weights.emplace_back(position->second, w);
    }
  }

  /// Standing waves of random amplitudes, four cells a wave length and more.
  void set_velocities() {
    std::mt19937 random(11);
    std::normal_distribution<double> any;
    for (int i = 1; i <= 4; ++i)
      for (int j = 1; j <= 4; ++j) {
        const double ax = 1e-3 * any(random);
        const double ay = 1e-3 * any(random);
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
          const double shape = std::sin(i * std::numbers::pi * at_[n].first / side) *
                               std::sin(j * std::numbers::pi * at_[n].second / side);
          nodes_[n].vx += ax * shape;
          nodes_[n].vy += ay * shape;
        }
      }
  }

  void move(double dt) {
    for (Node& node : nodes_)
      node.fx = node.fy = 0.0;
    for (const Point& p : points_)
      for (const auto& [n, w] : p.weights) {
        nodes_[n].fx -= p.area * (p.sxx * w.gx + p.sxy * w.gy);
        nodes_[n].fy -= p.area * (p.sxy * w.gx + p.syy * w.gy);
      }
    for (Node& node : nodes_) {
      node.vx = node.fixed ? 0.0 : node.vx + dt * node.fx / node.mass;
      node.vy = node.fixed ? 0.0 : node.vy + dt * node.fy / node.mass;
    }
  }

  void strain(double dt) {
    for (Point& p : points_) {
      double xx = 0.0, yy = 0.0, xy = 0.0;
      for (const auto& [n, w] : p.weights) {
        xx += nodes_[n].vx * w.gx;
        yy += nodes_[n].vy * w.gy;
        xy += nodes_[n].vx * w.gy + nodes_[n].vy * w.gx;
      }
      p.sxx += dt * (modulus * xx + lame * yy);
      p.syy += dt * (modulus * yy + lame * xx);
      p.sxy += dt * shear * xy;
    }
  }

  double kinetic() const {
    double sum = 0.0;
    for (const Node& node : nodes_)
      sum += 0.5 * node.mass * (node.vx * node.vx + node.vy * node.vy);
    return sum;
  }

  double finest_ = 0.0;
  std::vector<Node> nodes_;
  std::vector<std::pair<double, double>> at_;
  std::vector<Point> points_;
};

TEST(HardCase10WavesAcrossLevels, RandomWavesCrossLevelInterfacesAHundredTimes) {
  test_support::bounded("largest energy over that at the start",
                        TrappedWaves(Basis::virtual_nodes).run(100.0), 1.02);
  test_support::breaks("hanging nodes that the fine side alone sees: largest energy over that at the start",
                       TrappedWaves(Basis::naive).run(100.0), 1.02);
}

} // namespace
} // namespace tremolo::mpm_domain
