// A ring in a free block of soil, 12 m wide, that swings: momentum and angular momentum are exact, and energy
// falls, in every step where segments may open, and but for 1e-5 where they are bonded. The soil marches
// explicitly (leapfrog), for which
//
//     E_n = 1/2 v_{n+1/2} . M v_{n+1/2} + 1/2 u_n . K u_{n+1}
//
// is what it conserves by itself (Hairer, Lubich and Wanner 2006, section I.1.4, in the form for linear
// forces); the beam's energy is that of its present velocity and place.

#include "mpm_domain/lining/beam/beam_step.hpp"
#include "tests/support/lined_ring.hpp"
#include "tests/support/soil_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

class RingInSoil {
public:
  /// @param friction  negative: bonded
  explicit RingInSoil(double friction, std::vector<std::size_t> hinges = {})
      : bonded_(friction < 0.0), beam_(shape_of(lining(hinges)), ring_section),
        surface_(lining({}), beam_, 0.5), contact_(surface_),
        soil_(soil_box({-6.13, -5.79}, 24, 0.5, lining({}).outline, 2.0 * 1.3 * 1900.0 * 200.0 * 200.0, 0.3,
                       1900.0)) {
    const std::size_t nodes = soil_.mass.size();
    for (std::vector<double>* field : {&ux_, &uy_, &vx_, &vy_})
      field->assign(nodes, 0.0);
    for (SegmentContact& segment : contact_.segments())
      segment.friction = std::max(friction, 0.0);
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 0.3);
    for (std::size_t n = 0; n < nodes; ++n) {
      const Vector x = soil_.position(n);
      vx_[n] = has_soil(n) ? x.x / 3.0 + noise(random) : 0.0; // oval, 1 m/s at the ring
      vy_[n] = has_soil(n) ? -x.y / 3.0 + noise(random) : 0.0;
    }
    std::vector<double> v(beam_.positions().size(), 0.0);
    for (std::size_t k = 0; k < beam_.node_count(); ++k) {
      v[beam_.first_dof(k)] = beam_.position(k).x / 3.0;
      v[beam_.first_dof(k) + 1] = -beam_.position(k).y / 3.0;
    }
    beam_.set_velocities(v);
  }

  void step() {
    const std::vector<Vector> forces = soil_.forces(ux_, uy_);
    std::vector<double> wx = vx_;
    std::vector<double> wy = vy_;
    for (std::size_t n = 0; n < forces.size(); ++n)
      if (has_soil(n)) {
        wx[n] += dt / soil_.mass[n] * forces[n].x;
        wy[n] += dt / soil_.mass[n] * forces[n].y;
      }
    const std::vector<double> none(beam_.positions().size(), 0.0);
    const BeamStep beam_step(beam_, dt, dt, none);
    const std::vector<SegmentRows> rows = find_rows(surface_, beam_, soil_.lattice, soil_.mass, soil_.full);
    const std::vector<double> v = contact_.meet(rows, {soil_.mass, wx, wy}, beam_step, dt, dt, bonded_);
    for (const auto& [node, change, water] : contact_.changes(rows, {soil_.mass, wx, wy})) {
      wx[node] += change.x;
      wy[node] += change.y;
    }
    contact_.follow_gaps(rows, {soil_.mass, wx, wy}, v, dt);
    parting_ = 0.0;
    for (const SegmentRows& of : rows) {
      const Vector a = soil_velocity(of, wx, wy);
      const Vector b = beam_velocity(of, v);
      parting_ = std::max(parting_, std::hypot(a.x - b.x, a.y - b.y));
    }
    beam_.set_velocities(v);
    beam_.move(dt);
    vx_ = wx;
    vy_ = wy;
    energy_ = 0.0;
    for (std::size_t n = 0; n < forces.size(); ++n) {
      ux_[n] += dt * vx_[n];
      uy_[n] += dt * vy_[n];
      energy_ += 0.5 * soil_.mass[n] * (vx_[n] * vx_[n] + vy_[n] * vy_[n]) -
                 0.5 * (forces[n].x * ux_[n] + forces[n].y * uy_[n]);
    }
    energy_ += beam_.kinetic_energy() + beam_.strain_energy();
  }

  /// Sums of momentum along x and y, and of angular momentum about the origin.
  std::array<double, 3> momentum() const {
    std::array<double, 3> sums = momenta(beam_);
    for (std::size_t n = 0; n < soil_.mass.size(); ++n) {
      const Vector p{soil_.mass[n] * vx_[n], soil_.mass[n] * vy_[n]};
      sums[0] += p.x;
      sums[1] += p.y;
      sums[2] += cross(soil_.position(n), p);
    }
    return sums;
  }
  /// Sum of m |v| of the soil, kg/s m.
  double size() const {
    double sum = 0.0;
    for (std::size_t n = 0; n < soil_.mass.size(); ++n)
      sum += soil_.mass[n] * std::hypot(vx_[n], vy_[n]);
    return sum;
  }
  double energy() const { return energy_; }   ///< J/m
  double parting() const { return parting_; } ///< largest relative velocity of segments, m/s
  bool slides() const {
    return std::ranges::any_of(contact_.segments(), [](const SegmentContact& s) { return s.slip != 0; });
  }
  bool opens() const {
    return std::ranges::any_of(contact_.gaps(), [](double gap) { return gap > 0.0; });
  }

private:
  static constexpr double dt = 5.35e-4; // s

  static Lining lining(const std::vector<std::size_t>& hinges) {
    Lining ring = ring_lining();
    ring.hinges = hinges;
    return ring;
  }
  bool has_soil(std::size_t node) const { return soil_.mass[node] > soil_.empty(); }

  bool bonded_;
  Beam beam_;
  LiningSurface surface_;
  LiningContact contact_;
  SoilBox soil_;
  std::vector<double> ux_, uy_, vx_, vy_;
  double energy_ = 0.0;
  double parting_ = 0.0;
};

/// @param rise  of energy in a step, as a share of what there is at the start
void expect_to_lose_energy_alone(RingInSoil& scene, int steps, double rise) {
  const auto before = scene.momentum();
  const double size = scene.size();
  scene.step();
  double energy = scene.energy();
  const double start = energy;
  for (int k = 1; k < steps; ++k) {
    scene.step();
    EXPECT_LE(scene.energy(), energy + rise * start) << k;
    energy = scene.energy();
  }
  EXPECT_LT(energy, 0.97 * start);
  EXPECT_GT(energy, 0.05 * start);
  const auto after = scene.momentum();
  for (const std::size_t i : {0U, 1U, 2U})
    EXPECT_NEAR(after[i], before[i], 1e-12 * size * (i == 2 ? 6.0 : 1.0)) << i;
}

TEST(RingInSoil, KeepsMomentumWhereItSticks) {
  RingInSoil scene(-1.0);
  expect_to_lose_energy_alone(scene, 600, 2e-5);
  EXPECT_LT(scene.parting(), 1e-12);
}

TEST(RingInSoil, KeepsMomentumWhileItSlidesAndParts) {
  RingInSoil scene(0.4);
  scene.step();
  EXPECT_TRUE(scene.slides());
  EXPECT_TRUE(scene.opens());
  expect_to_lose_energy_alone(scene, 600, 1e-12);
}

TEST(RingInSoil, KeepsMomentumWithHinges) {
  RingInSoil scene(0.4, {0, 16, 32});
  expect_to_lose_energy_alone(scene, 300, 1e-12);
}

} // namespace
} // namespace tremolo::mpm_domain
