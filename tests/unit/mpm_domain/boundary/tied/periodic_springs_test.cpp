// Periodic sides by springs against the wrapped grid, which is exact.

#include "mpm_domain/boundary/tied/periodic_springs.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// A soft inclusion near the left side: what it scatters crosses the seam.
Spec box(double h, bool wrapped) {
  Spec spec = test_support::elastic_box(12.0, 6.0, h);
  spec.soils.push_back({"soft", materials::LinearElastic{{1700.0, 10e6, 0.28}}});
  spec.regions.push_back({1, {{2.0, -2.0}, {5.0, -2.0}, {5.0, 0.0}, {2.0, 0.0}}});
  spec.sides = wrapped ? Sides::periodic : Sides::periodic_springs;
  return spec;
}

/// A vertical SV pulse of 4 Hz at the base.
FreeFieldSource pulse_at_base(const Domain& domain) {
  return [&domain](long, double t, auto, std::span<eq6::FreeField> field) {
    const double a = std::pow(std::numbers::pi * 4.0 * (t - 0.4), 2);
    const double incident = 1e-3 * (1.0 - 2.0 * a) * std::exp(-a);
    for (std::size_t f = 0; f < field.size(); ++f)
      if (const BoundaryFace& face = domain.boundary.faces()[f]; face.side == Side::base)
        field[f] = {{incident, 0.0}, {0.0, 0.0, -face.ground.impedance_s * incident}};
  };
}

/// Velocities of all particles by soil and id, every 0.02 s.
std::vector<double> motion(double h, bool wrapped) {
  Domain domain(box(h, wrapped));
  Stepper stepper(domain, 0.0, pulse_at_base(domain));
  std::vector<double> velocities;
  while (stepper.time() < 1.2) {
    stepper.step();
    if (std::floor(stepper.time() / 0.02) == std::floor((stepper.time() - stepper.dt()) / 0.02))
      continue;
    for (const Particles& set : domain.sets)
      set.index_of.for_all([&](std::uint32_t k) {
        velocities.insert(velocities.end(), {set.vx[k], set.vy[k]});
      });
  }
  return velocities;
}

double difference(double h) {
  const std::vector<double> exact = motion(h, true);
  const std::vector<double> springs = motion(h, false);
  EXPECT_EQ(exact.size(), springs.size());
  double square = 0.0;
  double norm = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    square += std::pow(springs[i] - exact[i], 2);
    norm += exact[i] * exact[i];
  }
  return std::sqrt(square / norm);
}

TEST(PeriodicSprings, ApproachTheWrappedGridAtFirstOrder) {
  const double coarse = difference(1.0);
  const double fine = difference(0.5);
  EXPECT_LT(fine, 0.015); // measured: 0.0122
  EXPECT_GT(std::log2(coarse / fine), 0.85);
}

/// Random velocities that drift through the cells: nothing grows, and the sides stay together.
TEST(PeriodicSprings, AddNoEnergy) {
  Spec spec = box(0.5, false);
  spec.scheme.transfer = Transfer::flip; // which takes hardly any energy out by itself
  spec.scheme.order = StepOrder::usl;
  Domain domain(spec);
  for (BoundaryFace& face : domain.boundary.faces())
    face.ground.impedance_p = face.ground.impedance_s = 0.0;
  std::mt19937 random(3);
  std::normal_distribution<double> speed(0.0, 0.01);
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      set.vx[k] = 1.0 + speed(random);
      set.vy[k] = speed(random);
    }
  const auto kinetic = [&domain] { // of what does not drift, J/m
    double sum = 0.0;
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        sum += 0.5 * set.mass[k] * (std::pow(set.vx[k] - 1.0, 2) + std::pow(set.vy[k], 2));
    return sum;
  };
  const double before = kinetic();
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  double largest = 0.0;
  while (stepper.steps() < 3000) {
    stepper.step();
    largest = std::max(largest, kinetic());
  }
  EXPECT_LT(largest, 1.01 * before);
  EXPECT_GT(domain.sets.front().x[0] - domain.sets.front().x_initial[0], 1.0) << "two cells at least";
}

TEST(PeriodicSprings, RefuseSidesThatDoNotFaceEachOther) {
  Spec spec = test_support::elastic_box(6.0, 4.0, 1.0);
  spec.regions[0].polygon = {{0.0, -4.0}, {6.0, -4.0}, {6.0, -1.0}, {3.0, 0.0}, {0.0, 0.0}};
  spec.sides = Sides::periodic_springs;
  try {
    const Domain domain(spec);
    FAIL() << "not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("there are 8 on the left and 6 on the right"));
  }
}

} // namespace
} // namespace tremolo::mpm_domain
