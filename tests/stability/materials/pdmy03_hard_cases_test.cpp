// PDMY03 where it could break: no effective stress, separation and recompression, the apex, reversals on the
// failure surface, jumps of stress, increments from 1e-12 to those it refuses, all densities and pressures.

#include "pdmy03_bounds.hpp"

#include <algorithm>
#include <cstring>
#include <random>
#include <vector>

namespace tremolo::materials::test {
namespace {

TEST(Pdmy03HardCase, SixtySecondsOfShakingAtZeroEffectiveStress) {
  for (const double density : densities) {
    const Pdmy03 law = pdmy03({.relative_density = density});
    PointTest point(law, {-50e3, -100e3, -50e3, 0.0});
    for (int k = 0; k < 1000; ++k) {
      point.apply(sheared(0.0, 2e-4)); // by 20 %: dilation does not close it
    }
    const double work = point.plastic_work();
    const double gap = state_of(point).gap;
    EXPECT_GT(gap, 0.19);
    const double strength = law.ratio[law.surfaces] * law.residual_pressure;
    double path = 0.0;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int k = 0; k < 60 * 500; ++k) { // 60 s at 500 steps/s, 2 Hz with noise
      const double time = 0.002 * k;
      const double shear = 2e-5 * std::cos(4.0 * std::numbers::pi * time) + 1e-5 * unit(random);
      path += std::abs(shear);
      point.apply(sheared(shear, 1e-7 * unit(random)));
      ASSERT_TRUE(held(law, point.stress()));
      ASSERT_NEAR(mean_stress(point.stress()), 0.0, 1e-6);
      ASSERT_LE(shear_measure(point.stress()), strength * (1.0 + 1e-6));
    }
    EXPECT_GT(point.plastic_work(), work);
    EXPECT_LT(point.plastic_work() - work, strength * path);
  }
}

TEST(Pdmy03HardCase, ALiquefiedPointIsShakenForSixtySeconds) {
  for (const double density : densities) {
    const Pdmy03 law = pdmy03({.relative_density = density});
    PointTest point(law, {-5e2, -1e3, -5e2, 0.0});
    double largest = 0.0;
    for (int k = 0; k < 60 * 500; ++k) { // amplitude 0.24 %, no volume change
      point.apply(sheared(6e-5 * std::cos(4.0 * std::numbers::pi * 0.002 * k)));
      ASSERT_TRUE(held(law, point.stress()));
      largest = std::max(largest, -mean_stress(point.stress()));
    }
    EXPECT_LT(largest, 1e6) << density; // dilation in a strain range that stays does not pump pressure up
    EXPECT_GT(point.plastic_work(), 0.0);
  }
}

PointStep isotropic(double volume) {
  const Control third = Control::strain(volume / 3.0);
  return {third, third, Control::strain(0.0), 0.0, third};
}

/// Expansion of 1 % from 100 kPa and back in equal steps; relative error of the pressure that comes back.
double separated_and_closed(const Pdmy03& law, int steps) {
  PointTest point(law, {-100e3, -100e3, -100e3, 0.0});
  const double volume = 0.01;
  for (int k = 0; k < steps; ++k) {
    point.apply(isotropic(volume / steps));
    EXPECT_TRUE(held(law, point.stress()));
  }
  const double gap = state_of(point).gap;
  EXPECT_GT(gap, 0.5 * volume);
  for (int k = 1; k <= steps; ++k) {
    point.apply(isotropic(-volume / steps));
    if (k * volume / steps < gap) {
      EXPECT_EQ(mean_stress(point.stress()), 0.0);
    }
  }
  EXPECT_EQ(state_of(point).gap, 0.0);
  return std::abs(mean_stress(point.stress()) / 100e3 + 1.0);
}

TEST(Pdmy03HardCase, SeparationIsRememberedAndRecompressionGivesThePressureBack) {
  for (const double density : densities) {
    const Pdmy03 law = pdmy03({.relative_density = density});
    // the stiffness is that at the start of each part: an error of first order
    const double coarse = separated_and_closed(law, 2000);
    const double fine = separated_and_closed(law, 8000);
    EXPECT_LT(fine, 0.01) << density;
    EXPECT_NEAR(coarse / fine, 4.0, 0.4) << density;
  }
}

TEST(Pdmy03HardCase, ShearingAtTheApexFindsBothSides) {
  const Pdmy03 law = pdmy03({.relative_density = 0.57});
  for (const double lode : {-1.0, -0.5, 0.0, 0.5, 1.0}) { // triaxial extension to compression
    PointTest point(law, {-1e3, -1e3, -1e3, 0.0});
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int k = 0; k < 5000; ++k) {
      const double axial = 1e-5 * unit(random);
      const double volume = 1e-5 * unit(random);
      PointStep step = {Control::strain((volume + axial * (lode - 1.0)) / 3.0),
                        Control::strain((volume + 2.0 * axial) / 3.0), Control::strain(0.0), 0.0,
                        Control::strain((volume - axial * (1.0 + lode)) / 3.0)};
      point.apply(step);
      ASSERT_TRUE(held(law, point.stress())) << lode;
    }
  }
}

TEST(Pdmy03HardCase, ReversalOnTheFailureSurfaceIsElastic) {
  for (const double density : densities) {
    const Pdmy03 law = pdmy03({.relative_density = density});
    PointTest loaded(law, {-50e3, -100e3, -50e3, 0.0});
    for (int k = 0; k < 6000; ++k) {
      loaded.apply(sheared(5e-5));
    }
    ASSERT_GE(state_of(loaded).active_surface, static_cast<double>(law.surfaces) - 2.0);
    for (const double increment : {1e-12, 1e-10, 1e-8, 1e-6}) {
      PointTest point = loaded;
      const double height = law.residual_pressure - mean_stress(point.stress());
      const double modulus =
          law.elastic.shear_modulus() * std::sqrt(height / (law.reference_pressure + law.residual_pressure));
      const double before = point.stress().xy;
      point.apply(sheared(-increment));
      // centres at rest are single precision: so is the stress where unloading begins
      EXPECT_NEAR(before - point.stress().xy, modulus * increment, 1e-6 * before + 1e-3 * modulus * increment)
          << density << " " << increment;
      for (int k = 0; k < 1000; ++k) { // to and fro
        point.apply(sheared(k % 2 == 0 ? increment : -increment));
        ASSERT_TRUE(held(law, point.stress()));
      }
      EXPECT_NEAR(point.stress().xy, before, 2e-6 * before + 2.0 * modulus * increment) << density;
    }
  }
}

TEST(Pdmy03HardCase, AJumpOf500KPaInOneIncrementIsThatOfManySmallOnes) {
  for (const double density : densities) {
    const Pdmy03 law = pdmy03({.relative_density = density});
    const double strain = -500e3 / law.elastic.p_modulus();
    PointTest once(law, {-50e3, -100e3, -50e3, 0.0});
    PointTest slowly = once;
    once.apply({Control::strain(0.0), Control::strain(strain), Control::strain(0.0)});
    for (int k = 0; k < 1000; ++k) {
      slowly.apply({Control::strain(0.0), Control::strain(strain / 1000), Control::strain(0.0)});
    }
    ASSERT_TRUE(held(law, once.stress()));
    EXPECT_LT(once.stress().yy, -500e3);
    EXPECT_NEAR(once.stress().yy / slowly.stress().yy, 1.0, 0.03) << density;
    EXPECT_NEAR(once.stress().xx / slowly.stress().xx, 1.0, 0.03) << density;
  }
}

TEST(Pdmy03HardCase, IncrementsOf1em12AddUp) {
  const Pdmy03 law = pdmy03({.relative_density = 0.57});
  PointTest start(law, {-50e3, -100e3, -50e3, 0.0});
  for (int k = 0; k < 300; ++k) {
    start.apply(sheared(k < 200 ? 1e-5 : -1e-5));
  }
  for (const double sign : {1.0, -1.0}) {
    PointTest tiny = start;
    PointTest once = start;
    constexpr int count = 100000;
    for (int k = 0; k < count; ++k) {
      tiny.apply(sheared(sign * 1e-12));
    }
    once.apply(sheared(sign * 1e-12 * count));
    const double change = once.stress().xy - start.stress().xy;
    EXPECT_NEAR((tiny.stress().xy - start.stress().xy) / change, 1.0, 1e-3) << sign;
  }
}

/// Points in different states: sand sheared to and fro by different amounts.
struct Block {
  Pdmy03 law = pdmy03({.relative_density = 0.57});
  std::size_t count;
  std::vector<double> stress, state, work, strain;

  explicit Block(std::size_t n)
      : count(n), stress(4 * n), state(n * state_variables(law).size()), work(n), strain(4 * n) {
    for (std::size_t i = 0; i < n; ++i) {
      const double p = 1e3 * static_cast<double>(i + 1);
      stress[i] = stress[2 * n + i] = -0.5 * p;
      stress[n + i] = -p;
    }
    initialise(law, points(0, n));
  }

  Points points(std::size_t first, std::size_t n) {
    Points p;
    p.count = n;
    p.sxx = &stress[first];
    p.syy = &stress[count + first];
    p.szz = &stress[2 * count + first];
    p.sxy = &stress[3 * count + first];
    p.state = &state[first * state_variables(law).size()];
    p.plastic_work = &work[first];
    p.dexx = &strain[first];
    p.deyy = &strain[count + first];
    p.dgxy = &strain[2 * count + first];
    p.dwxy = &strain[3 * count + first];
    return p;
  }
};

/// Increments from elastic ones to those of many parts, in which points cross surfaces, reverse, enter the
/// plastic zone and open gaps, each at a time of its own: all points at once, in groups, and one by one.
TEST(Pdmy03HardCase, TheSameBitsHoweverPointsAreGrouped) {
  constexpr std::size_t count = 37;
  Block together(count);
  Block groups(count);
  Block alone(count);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::size_t apart = 0, inside = 0, dilating = 0;
  for (const double size : {1e-7, 3e-5, 1e-3, 3e-5}) {
    for (int k = 0; k < 150; ++k) {
      for (double& strain : together.strain)
        strain = 0.1 * size * unit(random);
      for (std::size_t i = 0; i < count; ++i)
        together.strain[2 * count + i] += size * std::cos(0.1 * k + static_cast<double>(i));
      groups.strain = alone.strain = together.strain;
      update(together.law, together.points(0, count));
      for (std::size_t first = 0, length = 1; first < count; first += length, length = length % 7 + 1) {
        length = std::min(length, count - first);
        update(groups.law, groups.points(first, length));
      }
      for (std::size_t i = 0; i < count; ++i)
        update(alone.law, alone.points(i, 1));
    }
    const auto same = [](const std::vector<double>& a, const std::vector<double>& b) {
      return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
    };
    for (const Block* other : {&groups, &alone}) {
      EXPECT_TRUE(same(together.stress, other->stress)) << size;
      EXPECT_TRUE(same(together.state, other->state)) << size;
      EXPECT_TRUE(same(together.work, other->work)) << size;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Pdmy03State state = load_pdmy03(&together.state[i * pdmy03_state_size(together.law.surfaces)]);
      apart += state.gap > 0.0 ? 1 : 0;
      inside += state.zone == pdmy03_zone::inside ? 1 : 0;
      dilating += state.zone == pdmy03_zone::dilating ? 1 : 0;
    }
  }
  EXPECT_GT(apart, 0U);
  EXPECT_GT(inside, 0U);
  EXPECT_GT(dilating, 0U);
}

TEST(Pdmy03HardCase, AnIncrementOfTenPerCentIsRefusedAndChangesNothing) {
  for (const double bad : {0.1, -0.1, std::numeric_limits<double>::quiet_NaN()}) {
    for (const std::size_t component : {0U, 1U, 2U}) {
      Block block(5);
      std::fill(block.strain.begin(), block.strain.end(), 1e-6);
      block.strain[component * block.count + 3] = bad;
      const Block before = block;
      try {
        update(block.law, block.points(0, block.count));
        FAIL() << "accepted " << bad;
      } catch (const std::domain_error& error) {
        EXPECT_NE(std::string(error.what()).find("pdmy03"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("point 3"), std::string::npos) << error.what();
      }
      EXPECT_EQ(block.stress, before.stress);
      EXPECT_EQ(0, std::memcmp(block.state.data(), before.state.data(), block.state.size() * sizeof(double)));
      EXPECT_EQ(block.work, before.work);
    }
  }
}

TEST(Pdmy03HardCase, StressOrStateThatIsNotFiniteIsRefusedAndChangesNothing) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    for (const bool in_state : {false, true}) {
      Block block(5);
      std::fill(block.strain.begin(), block.strain.end(), 1e-6);
      const std::size_t size = state_variables(block.law).size();
      (in_state ? block.state[3 * size + offsetof(Pdmy03State, gap) / sizeof(double)]
                : block.stress[2 * block.count + 3]) = bad;
      const Block before = block;
      try {
        update(block.law, block.points(0, block.count));
        FAIL() << "accepted " << bad;
      } catch (const std::domain_error& error) {
        EXPECT_NE(std::string(error.what()).find("pdmy03: "), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("of point 3 is "), std::string::npos) << error.what();
      }
      EXPECT_EQ(0,
                std::memcmp(block.stress.data(), before.stress.data(), block.stress.size() * sizeof(double)));
      EXPECT_EQ(0, std::memcmp(block.state.data(), before.state.data(), block.state.size() * sizeof(double)));
      EXPECT_EQ(block.work, before.work);
    }
  }
}

TEST(Pdmy03HardCase, EveryDensityPressureAndK0) {
  for (const double density : densities) {
    const Pdmy03 law = pdmy03({.relative_density = density});
    for (const double vertical : {1e3, 10e3, 100e3, 2e6}) {
      for (const double k0 : {0.3, 0.5, 1.0, 2.0}) {
        PointTest point(law, {-k0 * vertical, -vertical, -k0 * vertical, 0.0});
        ASSERT_TRUE(held(law, point.stress()));
        const double initial = -mean_stress(point.stress());
        double least = initial;
        for (int k = 0; k < 2000; ++k) { // cycles of 0.5 %
          point.apply(sheared((k / 250) % 2 == 0 ? 2e-5 : -2e-5));
          ASSERT_TRUE(held(law, point.stress())) << density << " " << vertical << " " << k0;
          least = std::min(least, -mean_stress(point.stress()));
        }
        EXPECT_LT(least, initial); // it has contracted
        EXPECT_GT(point.plastic_work(), 0.0);
      }
    }
  }
}

} // namespace
} // namespace tremolo::materials::test
