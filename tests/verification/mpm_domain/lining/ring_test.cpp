// Rings against closed forms: natural frequencies (Love 1944, section 293),
//
//     omega_n^2 = n^2 (n^2 - 1)^2/(n^2 + 1) EI/(rho t R^4),
//
// two opposite forces, and the critical pressure 3 EI/R^3 of water (Timoshenko and Gere 1961, section 7.3).

#include "tests/support/beam_ring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;
using std::numbers::pi;

/// Frequency of n waves around the ring, Hz.
double exact_frequency(int n) {
  const double n2 = n * n;
  const double stiffness = ring_section.bending / (ring_section.mass * std::pow(ring_radius, 4));
  return std::sqrt(n2 * (n2 - 1.0) * (n2 - 1.0) / (n2 + 1.0) * stiffness) / (2.0 * pi);
}

TEST(LiningRing, HasTheFrequenciesOfTheClosedForm) {
  const std::vector<double> of_ring = frequencies(Beam(ring_shape(64), euler_bernoulli(ring_section)));
  const std::vector<double> with_shear = frequencies(Beam(ring_shape(64), ring_section));
  for (std::size_t mode = 0; mode < 3; ++mode)
    EXPECT_EQ(of_ring[mode], 0.0); // rigid motion
  for (const int n : {2, 3, 4}) {
    const auto mode = static_cast<std::size_t>(2 * n - 1); // each comes twice
    EXPECT_NEAR(of_ring[mode], exact_frequency(n), 0.007 * exact_frequency(n)) << n;
    EXPECT_NEAR(of_ring[mode + 1], of_ring[mode], 1e-4 * exact_frequency(n)) << n;
    // Shear and rotary mass lower them, by about (n t/R)^2/6.
    EXPECT_NEAR(1.0 - with_shear[mode] / of_ring[mode], std::pow(n * ring_thickness / ring_radius, 2) / 6.0,
                0.0025)
        << n;
  }
}

TEST(LiningRing, BearsTwoOppositeForces) {
  const double p = 1e3; // N/m
  Beam ring(ring_shape(64), ring_section);
  std::vector<double> forces(ring.positions().size(), 0.0);
  forces[ring.first_dof(16) + 1] = -p; // on top
  forces[ring.first_dof(48) + 1] = p;
  rest_under(ring, forces, 60, 1.0);
  const auto [ea, ga, ei, mass, rotary] = ring_section;
  const double r = ring_radius;
  const double closing =
      p * r * r * r / ei * (pi / 4.0 - 2.0 / pi) + pi * p * r / 4.0 * (1.0 / ea + 1.0 / ga);
  const double top = ring_shape(64).nodes[16].y;
  EXPECT_NEAR(2.0 * (top - ring.position(16).y), closing, 0.002 * closing);
  // In the middle of the elements beside the side, half an element off it.
  EXPECT_NEAR(ring.forces(0).axial, -0.5 * p, 0.002 * p);
  EXPECT_NEAR(std::abs(ring.forces(0).moment), p * r * (0.5 - 1.0 / pi), 0.005 * p * r * (0.5 - 1.0 / pi));
  // M is linear in the element beside the force: the value at its end.
  const double at_force = ring.forces(16).moment + 0.5 * ring.elements()[16].length *
                                                       (ring.forces(16).moment - ring.forces(17).moment) /
                                                       ring.elements()[16].length;
  EXPECT_NEAR(std::abs(at_force), p * r / pi, 0.01 * p * r / pi);
}

/// How many directions a ring of n nodes can buckle in under a pressure that turns with its surface.
int ways_to_buckle(std::size_t nodes, double pressure) {
  const BeamShape shape = ring_shape(nodes);
  Beam ring(shape, euler_bernoulli(ring_section));
  // The thrust of two elements balances the pressure on the halves that meet at their node.
  std::vector<double> state = ring.state();
  const std::size_t strains = 2 * ring.positions().size();
  for (std::size_t e = 0; e < nodes; ++e) {
    const double l = ring.elements()[e].length;
    const double thrust = pressure * l / (2.0 * std::tan(pi / static_cast<double>(nodes)));
    state[strains + 3 * e] = -thrust * l / ring_section.axial;
  }
  ring.set_state(state);
  Eigen::MatrixXd k = tangent(ring);
  for (std::size_t a = 0; a < nodes; ++a) {
    // The force on both ends of an edge from a to b is p/2 (-(y_b - y_a), x_b - x_a).
    const auto from = static_cast<Eigen::Index>(ring.first_dof(a));
    const auto to = static_cast<Eigen::Index>(ring.first_dof((a + 1) % nodes));
    for (const Eigen::Index end : {from, to}) {
      k(end, to + 1) += 0.5 * pressure;
      k(end, from + 1) -= 0.5 * pressure;
      k(end + 1, to) -= 0.5 * pressure;
      k(end + 1, from) += 0.5 * pressure;
    }
  }
  const Eigen::VectorXd scale = k.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * (0.5 * (k + k.transpose())) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scaled, Eigen::EigenvaluesOnly);
  return static_cast<int>((modes.eigenvalues().array() < -2e-8).count());
}

double critical_pressure(std::size_t nodes) {
  double low = 0.0;
  double high = 20e6;
  while (high - low > 1e3) {
    const double middle = 0.5 * (low + high);
    (ways_to_buckle(nodes, middle) > 0 ? high : low) = middle;
  }
  return high;
}

TEST(LiningRing, BucklesUnderAPressureThatFollowsIt) {
  const double exact = 3.0 * ring_section.bending / std::pow(ring_radius, 3);
  EXPECT_NEAR(critical_pressure(32), exact, 0.01 * exact);
  EXPECT_NEAR(critical_pressure(64), exact, 0.004 * exact);
}

TEST(LiningRing, IsAMechanismWithFourHinges) {
  const auto zero_modes = [](const std::vector<std::size_t>& hinges) {
    const std::vector<double> of_ring = frequencies(Beam(ring_shape(64, hinges), ring_section));
    std::size_t zero = 0;
    while (of_ring[zero] < 0.3) // Hz
      ++zero;
    return std::pair{zero, of_ring[zero]};
  };
  const auto [of_none, none] = zero_modes({});
  const auto [of_three, three] = zero_modes({0, 16, 32});
  const auto [of_four, four] = zero_modes({0, 16, 32, 48});
  EXPECT_EQ(of_none, 3U);
  EXPECT_EQ(of_three, 3U);
  EXPECT_EQ(of_four, 4U);
  EXPECT_NEAR(none, 14.43, 0.03);
  EXPECT_NEAR(three, 5.41, 0.05);
  EXPECT_NEAR(four, 14.43, 0.1);
}

} // namespace
} // namespace tremolo::mpm_domain
