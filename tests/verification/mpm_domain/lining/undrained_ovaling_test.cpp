// A ring in saturated ground that is sheared faster than its water flows. Water then moves with the grains
// and makes the ground stiffer against compression alone, by K_f/n, so that the ring is that of dry ground
// (sheared_ring.hpp) with
//
//     K_u = K + K_f/n,      nu_u = (3 K_u - 2 G)/(2 (3 K_u + G)),
//
// which goes to 1/2. The ground has come to rest around the ring, K_0 = nu/(1 - nu), and then bears a shear
// stress on its surface; its sides are periodic.

#include "tests/support/sheared_ring.hpp"
#include "tests/support/structure_scene.hpp"
#include "tests/support/wet_lining.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

constexpr double young = 2e8, poisson = 0.3;
constexpr double strain = 1e-4;
constexpr double shear = young / (2.0 * (1.0 + poisson));

struct Fast {
  double bulk_modulus; ///< K_f, Pa; 0: it is sheared slowly
  bool sticks;         ///< no slip; else full slip
  double width;        ///< of the ground, m

  bool undrained() const { return bulk_modulus > 0.0; }
  /// nu_u
  double poisson_ratio() const {
    const double bulk = young / (3.0 * (1.0 - 2.0 * poisson)) + bulk_modulus / heavy_fluid::porosity;
    return (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear));
  }
};

void PrintTo(const Fast& fast, std::ostream* to) {
  *to << "K_f = " << fast.bulk_modulus << " Pa, " << (fast.sticks ? "no slip, " : "full slip, ") << fast.width
      << " m wide";
}

/// On cells of 0.5 m around the ring.
Spec ground_with_ring(const Fast& fast) {
  const double cell = fast.width / 40.0;
  const double depth = 32.0 * cell;
  Spec spec = saturated_flat_ground(fast.width, depth, cell, materials::Drainage::undrained, young);
  spec.water->fluid.bulk_modulus = fast.undrained() ? fast.bulk_modulus : 2.2e8;
  spec.sides = Sides::periodic;
  const auto levels = static_cast<int>(std::lround(std::log2(cell / 0.5)));
  for (int level = 1; level <= levels; ++level) {
    const double half = 6.0 + 4.0 * (levels - level);
    spec.refine.push_back({{-half, -0.5 * depth - half, half, -0.5 * depth + half}, level});
  }
  spec.linings = {concrete_lining({0.13, -0.5 * depth - 0.21}, fast.sticks ? 10.0 : 0.0)};
  spec.loads = {{.x_min = -0.5 * fast.width, .x_max = 0.5 * fast.width, .shear = shear * strain}};
  return spec;
}

/// Amplitudes of cos 2 phi.
struct Amplitudes {
  double thrust = 0.0, moment = 0.0;
};

Amplitudes amplitudes(const Beam& beam) {
  Amplitudes sums;
  const auto count = static_cast<double>(beam.elements().size());
  for (std::size_t e = 0; e < beam.elements().size(); ++e) {
    const double share =
        2.0 / count * std::sin(4.0 * std::numbers::pi * (static_cast<double>(e) + 0.5) / count);
    sums.thrust += share * beam.forces(e).axial;
    sums.moment += share * beam.forces(e).moment;
  }
  return sums;
}

/// What the shear stress changes.
Amplitudes change_by_shear(const Spec& spec, bool undrained) {
  Domain domain(spec);
  const std::vector<StaticStage> stages{
      LoadSettings{{.ramp = 0.5, .residual = 1e-6, .max_time = 60.0, .undrained = {undrained}}, 0}};
  std::vector<Amplitudes> before;
  bring_to_rest(domain, {.residual = 1e-6}, stages, [&](std::size_t stage, long, double) {
    if (stage == 1 && before.empty())
      before.push_back(amplitudes(domain.linings.bodies().front().beam()));
  });
  const Amplitudes after = amplitudes(domain.linings.bodies().front().beam());
  return {after.thrust - before.front().thrust, after.moment - before.front().moment};
}

void expect_forces_of_exact_solution(const Fast& fast) {
  const RingInShear exact(shear, fast.poisson_ratio(), strain, fast.sticks);
  const Amplitudes change = change_by_shear(ground_with_ring(fast), fast.undrained());
  testing::Test::RecordProperty("poisson", std::to_string(fast.poisson_ratio()));
  testing::Test::RecordProperty("thrust", std::to_string(change.thrust / exact.thrust));
  testing::Test::RecordProperty("moment", std::to_string(change.moment / exact.moment));
  EXPECT_NEAR(change.thrust, exact.thrust, 0.02 * std::abs(exact.thrust));
  EXPECT_NEAR(change.moment, exact.moment, 0.02 * std::abs(exact.moment));
}

class RingInWetGround : public testing::TestWithParam<Fast> {};

TEST_P(RingInWetGround, TakesThrustAndMomentOfUndrainedGround) {
  expect_forces_of_exact_solution(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Waters, RingInWetGround,
                         testing::Values(Fast{0.0, true, 40.0}, Fast{2.2e8, true, 40.0}));

class AcceptanceRingInWetGround : public testing::TestWithParam<Fast> {};

TEST_P(AcceptanceRingInWetGround, TakesThrustAndMomentOfUndrainedGround) {
  expect_forces_of_exact_solution(GetParam());
}

// A ring that slips feels the surface and the base from farther away.
INSTANTIATE_TEST_SUITE_P(Waters, AcceptanceRingInWetGround,
                         testing::Values(Fast{2.2e9, true, 40.0}, Fast{0.0, false, 80.0},
                                         Fast{2.2e9, false, 80.0}));

} // namespace
} // namespace tremolo::mpm_domain
