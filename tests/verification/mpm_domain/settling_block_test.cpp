// A heavy block on clay that yields under it while a sine of 0.15 g shakes the ground: sides and base of a
// small box hold its weight once the shaking is over. References are a box of 192 m by 60 m in which 12 m of
// clay lie over elastic ground, 166.3 mm before matched layers and 171.3 mm before springs.

#include "tests/support/box_models.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace tremolo {
namespace {

using namespace test_support;

constexpr double depth = 12.0; // m
constexpr materials::Elasticity ground{1800.0, 25e6, 0.45};

/// The velocity of an outcrop, whose acceleration is a sine of 1 Hz that grows over two seconds and fades
/// over the last two of twenty.
class Outcrop {
public:
  Outcrop() {
    double v = 0.0;
    double before = 0.0;
    for (int i = 0; i <= 4500; ++i) {
      const double a = acceleration(interval * i);
      v += 0.5 * interval * (before + a);
      before = a;
      velocities_.push_back(v);
    }
  }
  double velocity(double time) const {
    const double at = std::clamp(time / interval, 0.0, double(velocities_.size() - 2));
    const auto i = static_cast<std::size_t>(at);
    return velocities_[i] + (at - double(i)) * (velocities_[i + 1] - velocities_[i]);
  }

private:
  static constexpr double interval = 0.01; // s
  static double acceleration(double t) {
    const double envelope = std::clamp(std::min(t, 20.0 - t) / 2.0, 0.0, 1.0);
    return 0.15 * 9.81 * envelope * std::sin(2.0 * std::numbers::pi * t);
  }
  std::vector<double> velocities_;
};

/// Half of the outcrop's motion goes up through (0, -depth), and down again from the surface.
mpm_domain::FreeFieldSource vertical_wave(const mpm_domain::Domain& domain, const Outcrop& outcrop) {
  return [&domain, &outcrop](long, double t, auto, std::span<eq6::FreeField> field) {
    const double c = ground.s_wave_speed();
    for (std::size_t f = 0; f < field.size(); ++f) {
      const double y = domain.boundary.faces()[f].position.y;
      const double up = 0.5 * outcrop.velocity(t - (y + depth) / c);
      const double down = 0.5 * outcrop.velocity(t - (depth - y) / c);
      field[f] = {{up + down, 0.0}, {0.0, 0.0, -ground.density * c * (up - down)}};
    }
  };
}

struct Settlement {
  double last = 0.0;     ///< at 40 s, m
  double in_ten_s = 0.0; ///< in the last 10 s, m
};

/// @param across  a_n, and half of it is a_t; 0: dashpots alone
Settlement settlement(double across) {
  mpm_domain::Spec spec;
  spec.box = {-24.0, -depth, 24.0, 0.0};
  spec.cell_size = 1.0;
  spec.gravity = 9.81;
  materials::MohrCoulomb clay;
  clay.elastic = ground;
  clay.cohesion_peak = clay.cohesion_residual = 32e3;
  spec.soils = {{"clay", clay}};
  spec.regions = {{0, rectangle(-24.0, -depth, 24.0, 0.0)}};
  spec.structures = {structure(rectangle(-3.0, 0.0, 3.0, 8.0), 1250.0, 0.6)};
  spec.scheme.fraction = 0.8;
  spec.threads = 1;
  if (across > 0.0)
    add_springs(spec, across, 0.5 * across, {0.0, 0.0});
  mpm_domain::Domain domain(spec);
  mpm_domain::replace_constraints(domain, mpm_domain::relax_under_gravity(domain, {}, [](long, double) {}));
  const Outcrop outcrop;
  mpm_domain::Stepper stepper(domain, 0.0, vertical_wave(domain, outcrop));
  const auto height = [&] { return domain.contact.bodies().front().centre().y; };
  const double start = height();
  double before = start;
  while (stepper.time() < 40.0) {
    stepper.step();
    if (stepper.time() < 30.0)
      before = height();
  }
  testing::Test::RecordProperty("settlement_mm_a" + std::to_string(across),
                                std::to_string(1e3 * (start - height())));
  testing::Test::RecordProperty("residual_J_a" + std::to_string(across),
                                std::to_string(domain.energy.residual()));
  return {start - height(), before - height()};
}

TEST(SettlingBlock, IsHeldBySprings) {
  const Settlement found = settlement(1.0);
  EXPECT_NEAR(found.last, 0.204, 0.010);
  EXPECT_LT(std::abs(found.in_ten_s), 0.2e-3);
}

TEST(SettlingBlock, AcceptanceIsHeldHigherByStifferSprings) {
  const Settlement found = settlement(2.0);
  EXPECT_NEAR(found.last, 0.167, 0.008);
  EXPECT_LT(std::abs(found.in_ten_s), 0.2e-3);
}

TEST(SettlingBlock, AcceptanceSinksOnDashpotsAlone) {
  const Settlement found = settlement(0.0);
  EXPECT_GT(found.last, 0.4);
  EXPECT_GT(found.in_ten_s, 1e-3);
}

} // namespace
} // namespace tremolo
