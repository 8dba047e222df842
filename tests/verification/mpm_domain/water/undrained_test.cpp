// Motion that is too fast for water to leave: the share of the water in a load, Q/(M + Q), whether water is
// locked to the grains or drag holds it there, and the speeds of the fronts of pressure, c_u where drag locks
// and c_1 where there is hardly any (verification C3; Verruijt 2010, An Introduction to Soil Dynamics, ch.
// 5).

#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "tests/support/growing_load.hpp"
#include "tests/verification/mpm_domain/water/saturated_column.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <tuple>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::SaturatedColumn;

/// act(set, k) for all wet particles.
template <typename Act>
void for_wet(const Domain& domain, const Act& act) {
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
      act(set, k);
}

double excess(const Particles& set, std::size_t k) {
  return excess_pressure(set, k);
}

/// A load taken slowly by soil that does not drain, to 0.1 %.
class UndrainedLoad : public testing::TestWithParam<std::tuple<double, materials::Drainage>> {};

TEST_P(UndrainedLoad, IsSharedByStiffness) {
  const auto [modulus, drainage] = GetParam();
  SaturatedColumn column;
  column.height = 5.0;
  column.cell = 0.25;
  column.p_modulus = modulus;
  column.poisson = 0.25;
  column.pores.permeability = 1e-9;
  column.pores.drainage = drainage;
  constexpr double first = 100.0; // Pa
  constexpr double grown = 101.0; // times as much
  constexpr double added = (grown - 1.0) * first;
  column.load = first;
  const auto domain = column.at_rest();
  const test_support::GrowingLoad load(*domain, "load");
  Stepper stepper(*domain, 0.0, test_support::at_rest_source());
  constexpr double ramp = 0.2; // s, some ten periods of the column: no ringing stays
  while (stepper.time() < ramp + 0.05) {
    load.grow(1.0 + (grown - 1.0) * test_support::smooth_step(stepper.time() / ramp));
    stepper.step();
  }
  const double q = materials::pore_stiffness(column.pores, column.fluid);
  const double exact = q / (modulus + q);
  for_wet(*domain, [&](const Particles& set, std::size_t k) {
    EXPECT_NEAR(excess(set, k) / added, exact, 1e-3 * exact) << set.y[k];
  });
}

INSTANTIATE_TEST_SUITE_P(Stiffness, UndrainedLoad,
                         testing::Combine(testing::Values(1e7, 1e8, 5e8),
                                          testing::Values(materials::Drainage::coupled,
                                                          materials::Drainage::undrained)),
                         [](const auto& test) {
                           const long modulus = std::lround(std::get<0>(test.param) / 1e6);
                           return std::to_string(modulus) + "MPa_" +
                                  std::string(tremolo::name(std::get<1>(test.param)));
                         });

/// Endless drag is one velocity of grains and water: the two-velocity step gives what the step of locked
/// soil gives, here under noise. Strains are minute, since the mass of water in a particle follows its pores
/// where water flows and stays where it is locked: both differ in proportion to strain.
class EndlessDrag : public testing::TestWithParam<std::tuple<Transfer, StepOrder>> {
protected:
  static std::unique_ptr<Domain> after_noise(materials::Drainage drainage) {
    SaturatedColumn column;
    column.height = 3.0;
    column.cell = 0.25;
    column.cells_wide = 8;
    column.p_modulus = 1e8;
    column.poisson = 0.25;
    column.pores.permeability = 1e-30;
    column.pores.drainage = drainage;
    column.scheme.transfer = std::get<Transfer>(GetParam());
    column.scheme.order = std::get<StepOrder>(GetParam());
    column.scheme.dt = 3e-5; // s
    // Nodes shared with dry soil: only the transfer APIC gives grains and water the same new velocity there,
    // and the remapped velocities of both are means over other masses.
    const bool dry_layer = column.scheme.transfer == Transfer::apic && column.scheme.order == StepOrder::usl;
    column.load = dry_layer ? 1e4 : 0.0;
    Spec spec = column.spec();
    spec.gravity = 1e-9; // no stress at rest whose rounding would show
    auto domain = std::make_unique<Domain>(spec);
    std::mt19937 random(3);
    std::normal_distribution<double> speed(0.0, 1e-10); // m/s
    for (Particles& set : domain->sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        set.vx[k] = speed(random);
        set.vy[k] = speed(random);
        if (set.traits.flowing) {
          set.wx[k] = set.vx[k];
          set.wy[k] = set.vy[k];
        }
      }
    Stepper stepper(*domain, 0.0, test_support::at_rest_source());
    for (int step = 0; step < 300; ++step)
      stepper.step();
    return domain;
  }
};

TEST_P(EndlessDrag, IsOneVelocity) {
  const auto coupled = after_noise(materials::Drainage::coupled);
  const auto locked = after_noise(materials::Drainage::undrained);
  std::array<double, 3> difference{}, size{}; // of velocity, effective stress, pressure
  const auto compare = [](const std::vector<double>& a, const std::vector<double>& b, double& most,
                          double& largest) {
    for (std::size_t k = 0; k < a.size(); ++k) {
      most = std::max(most, std::abs(a[k] - b[k]));
      largest = std::max(largest, std::abs(b[k]));
    }
  };
  for (std::size_t s = 0; s < coupled->sets.size(); ++s) {
    const Particles& a = coupled->sets[s];
    const Particles& b = locked->sets[s];
    ASSERT_EQ(a.size(), b.size());
    compare(a.vx, b.vx, difference[0], size[0]);
    compare(a.vy, b.vy, difference[0], size[0]);
    compare(a.sxy, b.sxy, difference[1], size[1]);
    compare(a.syy, b.syy, difference[1], size[1]);
    if (a.traits.wet)
      compare(a.pore_pressure, b.pore_pressure, difference[2], size[2]);
  }
  for (std::size_t i = 0; i < size.size(); ++i)
    EXPECT_LT(difference[i], 1e-12 * size[i]) << i;
}

INSTANTIATE_TEST_SUITE_P(Schemes, EndlessDrag,
                         testing::Combine(testing::Values(Transfer::apic, Transfer::flip),
                                          testing::Values(StepOrder::musl, StepOrder::usl)),
                         [](const auto& test) {
                           return std::string(tremolo::name(std::get<0>(test.param))) + "_" +
                                  std::string(tremolo::name(std::get<1>(test.param)));
                         });

/// Speed of the front of pressure that a jerk of the base sends up: from the times at which half of the
/// plateau behind it reaches two heights.
double front_speed(double permeability, materials::Drainage drainage) {
  SaturatedColumn column;
  column.height = 20.0;
  column.cell = 0.1;
  column.p_modulus = 1e8;
  column.poisson = 0.25;
  column.load = 0.0;
  column.pores.permeability = permeability;
  column.pores.drainage = drainage;
  const auto domain = column.at_rest();
  constexpr double rigid = 1e3;
  for (BoundaryFace& face : domain->boundary.faces())
    face.ground.impedance_p *= rigid;
  constexpr double jerk = 1e-2; // m/s
  Stepper stepper(*domain, 0.0, [](long, double, std::span<const Vector>, std::span<eq6::FreeField> field) {
    std::ranges::fill(field, eq6::FreeField{{0.0, jerk}, {}});
  });
  const auto pressure_at = [&](double height) {
    double sum = 0.0;
    int count = 0;
    for_wet(*domain, [&](const Particles& set, std::size_t k) {
      if (std::abs(set.y_initial[k] + column.height - height) < 0.5 * column.cell) {
        sum += excess(set, k);
        ++count;
      }
    });
    return sum / count;
  };
  constexpr std::array heights = {5.05, 15.05}; // m, centres of cells
  std::array<std::vector<double>, 2> history;
  std::vector<double> time;
  while (stepper.time() < 17.0 / 1650.0) {
    stepper.step();
    time.push_back(stepper.time());
    for (std::size_t i = 0; i < heights.size(); ++i)
      history[i].push_back(pressure_at(heights[i]));
  }
  // The plateau behind the front at the lower height, some metres behind the front and before the reflection.
  double plateau = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < time.size(); ++i)
    if (time[i] > 8.0 / 1650.0 && time[i] < 12.0 / 1650.0) {
      plateau += history[0][i];
      ++count;
    }
  plateau /= count;
  std::array<double, 2> arrival{};
  for (std::size_t h = 0; h < heights.size(); ++h)
    for (std::size_t i = 1; i < time.size() && arrival[h] == 0.0; ++i)
      if (history[h][i] >= 0.5 * plateau)
        arrival[h] = time[i] - (time[i] - time[i - 1]) * (history[h][i] - 0.5 * plateau) /
                                   (history[h][i] - history[h][i - 1]);
  return (heights[1] - heights[0]) / (arrival[1] - arrival[0]);
}

TEST(SaturatedFront, RunsAtTheUndrainedSpeedWhereDragLocks) {
  const double speed = materials::saturated_speeds(1e8, SaturatedColumn{}.pores, {}).undrained;
  EXPECT_NEAR(front_speed(1e-5, materials::Drainage::coupled), speed, 0.02 * speed);
  EXPECT_NEAR(front_speed(1e-5, materials::Drainage::undrained), speed, 0.02 * speed);
}

TEST(SaturatedFront, RunsAtTheFastSpeedWithoutDrag) {
  const double speed = materials::saturated_speeds(1e8, SaturatedColumn{}.pores, {}).fast;
  EXPECT_NEAR(front_speed(1e3, materials::Drainage::coupled), speed, 0.02 * speed);
}

} // namespace
} // namespace tremolo::mpm_domain
