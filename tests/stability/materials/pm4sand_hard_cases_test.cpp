// Paths that break implementations of PM4Sand: no effective stress, separation, reversals on the bounding
// surface, large, tiny and refused increments, extreme soils and stresses.

#include "tests/support/pm4sand_bounds.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <numbers>
#include <stdexcept>

namespace tremolo::materials::test {
namespace {

PointStep shear(double strain) {
  return {Control::strain(0.0), Control::strain(0.0), Control::strain(strain)};
}

/// Isotropic extension in the plane by a volumetric strain.
PointStep extension(double volumetric) {
  return {Control::strain(0.5 * volumetric), Control::strain(0.5 * volumetric)};
}

pm4::State state_of(const PointTest& point) {
  return pm4::load(point.state().data());
}

constexpr double shaking_time = 60.0; // s
constexpr double time_step = 5e-3;    // s

/// Shear strain of 1 Hz shaking at a time.
double shaking(double time, double amplitude) {
  return amplitude * std::sin(2.0 * std::numbers::pi * time);
}

/// Liquefied sand at constant volume: 1 per cent of shear strain dilates it at each cycle, and it falls back
/// to less than a twentieth of its initial pressure in between.
TEST(Pm4Hard, ShakingWhenLiquefied) {
  const Pm4Sand law = report_sand(55);
  PointTest point(law, geostatic(50.0 * kilopascal, 0.5));
  double highest = 0.0;
  double lowest = 1e9;
  for (double time = 0.0; time < shaking_time; time += time_step) {
    point.apply(shear(shaking(time + time_step, 0.01) - shaking(time, 0.01)));
    ASSERT_EQ(broken_bound(law, point), "") << time;
    if (time > 20.0) {
      highest = std::max(highest, pressure(point.stress()));
      lowest = std::min(lowest, pressure(point.stress()));
    }
  }
  EXPECT_LT(highest, 30.0 * kilopascal);
  EXPECT_LT(lowest, 0.05 * 37.5 * kilopascal);
}

/// Soil pulled apart faster than shearing dilates it: the stress stays at the floor through 60 s.
TEST(Pm4Hard, ShakingAtZeroEffectiveStress) {
  const Pm4Sand law = report_sand(55);
  PointTest point(law, geostatic(50.0 * kilopascal, 0.5));
  for (int n = 0; n < 400; ++n) {
    point.apply(extension(5e-6));
  }
  const double floor = pm4::floor_pressure(state_of(point).start);
  for (double time = 0.0; time < shaking_time; time += time_step) {
    PointStep step = shear(shaking(time + time_step, 1e-3) - shaking(time, 1e-3));
    step.xx = Control::strain(5e-5);
    point.apply(step);
    ASSERT_EQ(broken_bound(law, point), "") << time;
    ASSERT_NEAR(pressure(point.stress()), floor, 1e-9 * floor) << time;
  }
  EXPECT_GT(state_of(point).now.gap, 0.1);
}

/// Isotropic extension to separation and back: no shear, so that all of it is elastic and the stress comes
/// back; the gap is the strain beyond the floor in closed form.
TEST(Pm4Hard, SeparationAndRecompression) {
  const Pm4Sand law = report_sand(55);
  const double p_0 = 100.0 * kilopascal;
  const double stretch = 4e-3;
  for (const int steps : {1, 40, 4000}) {
    PointTest point(law, geostatic(p_0, 1.0));
    for (int n = 0; n < steps; ++n) {
      point.apply(extension(stretch / steps));
    }
    const double p_min = 0.005 * law.p_A;
    const double bulk = 2.5 * law.G_o * std::sqrt(law.p_A); // (K + G/3)/sqrt(p)
    const double to_floor =
        2.0 * (std::sqrt(p_0) - std::sqrt(p_min)) / bulk + 0.8 * p_min / (bulk * std::sqrt(p_min));
    EXPECT_NEAR(state_of(point).now.gap, stretch - to_floor, 1e-4 * stretch) << steps;
    EXPECT_NEAR(pressure(point.stress()), 0.2 * p_min, 1e-9 * p_min);

    const double gap = state_of(point).now.gap;
    point.apply(extension(-0.9 * gap)); // not closed yet
    EXPECT_NEAR(pressure(point.stress()), 0.2 * p_min, 1e-9 * p_min);
    for (int n = 0; n < steps; ++n) {
      point.apply(extension(-(stretch - 0.9 * gap) / steps));
    }
    EXPECT_EQ(state_of(point).now.gap, 0.0);
    EXPECT_NEAR(pressure(point.stress()), p_0, 2e-3 * p_0) << steps;
    EXPECT_EQ(broken_bound(law, point), "");
  }
}

/// Extension along one axis and sheared while apart, then recompressed: it resists again once the gap has
/// closed, wherever the shear stress points.
TEST(Pm4Hard, TensionToSeparationWithShear) {
  for (const double sign : {1.0, -1.0}) {
    const Pm4Sand law = report_sand(55);
    PointTest point(law, geostatic(50.0 * kilopascal, 0.5));
    for (int n = 0; n < 500; ++n) {
      point.apply({Control::strain(0.0), Control::strain(1e-5), Control::strain(sign * 2e-6)});
      ASSERT_EQ(broken_bound(law, point), "") << n;
    }
    EXPECT_GT(state_of(point).now.gap, 1e-3);
    EXPECT_GE(sign * point.stress().xy, 0.0); // the direction of shear is kept
    for (int n = 0; n < 800; ++n) {
      point.apply({Control::strain(0.0), Control::strain(-1e-5), Control::strain(sign * 2e-6)});
      ASSERT_EQ(broken_bound(law, point), "") << n;
    }
    EXPECT_EQ(state_of(point).now.gap, 0.0);
    EXPECT_GT(pressure(point.stress()), 10.0 * kilopascal);
    EXPECT_GT(sign * point.stress().xy, 0.0);
  }
}

/// Reversals from the bounding surface: the first small increment back is elastic or nearly so, and stiff.
TEST(Pm4Hard, ReversalOnTheBoundingSurface) {
  const Pm4Sand law = report_sand(75);
  PointTest point(law, geostatic(100.0 * kilopascal, 0.5));
  double direction = 1.0;
  for (const double amplitude : {0.05, 0.10, 0.10, 0.02, 0.01}) {
    const int steps = static_cast<int>(amplitude / 1e-4);
    for (int n = 0; n < steps; ++n) {
      point.apply(shear(direction * 1e-4));
      ASSERT_EQ(broken_bound(law, point), "");
    }
    direction = -direction;
    const double before = point.stress().xy;
    const pm4::State state = state_of(point);
    const pm4::Site here =
        pm4::site(law, state.start, state.memory, state.now, held_stress(point.stress(), state));
    point.apply(shear(direction * 1e-8));
    const double stiffness = (point.stress().xy - before) / (direction * 1e-8);
    EXPECT_NEAR(stiffness, here.G, 1e-3 * here.G) << amplitude;
  }
}

/// One increment that compresses the soil by more than 500 kPa is as good as a thousand small ones.
TEST(Pm4Hard, JumpOf500KPaInOneIncrement) {
  const Pm4Sand law = report_sand(55);
  PointTest at_once(law, geostatic(100.0 * kilopascal, 0.5));
  PointTest slowly(law, geostatic(100.0 * kilopascal, 0.5));
  constexpr double squeeze = 3e-3;
  constexpr double distortion = 5e-4;
  at_once.apply({Control::strain(0.0), Control::strain(-squeeze), Control::strain(distortion)});
  for (int n = 0; n < 1000; ++n) {
    slowly.apply(
        {Control::strain(0.0), Control::strain(-squeeze / 1000), Control::strain(distortion / 1000)});
  }
  const double p = pressure(slowly.stress());
  EXPECT_GT(pressure(at_once.stress()), 575.0 * kilopascal);
  EXPECT_NEAR(at_once.stress().xx, slowly.stress().xx, 1e-3 * p);
  EXPECT_NEAR(at_once.stress().yy, slowly.stress().yy, 1e-3 * p);
  EXPECT_NEAR(at_once.stress().xy, slowly.stress().xy, 1e-3 * p);
  EXPECT_EQ(broken_bound(law, at_once), "");
}

/// Pulled apart, with the stress on the yield surface to within rounding, and strained along that surface:
/// what is left of the way to it is nothing, and the step ends all the same.
TEST(Pm4Hard, LoadingAlongTheYieldSurfaceWithAnOpenGapEnds) {
  const Pm4Sand law = report_sand(55);
  for (int n = 0; n < 400; ++n) {
    const double angle = 2.0 * std::numbers::pi * n / 400.0;
    PointTest point(law, geostatic(50.0 * kilopascal, 1.0));
    point.apply(extension(0.01));
    PointState apart = point.now();
    pm4::State state = pm4::load(apart.variables.data());
    ASSERT_GT(state.now.gap, 0.0);
    const double p = pm4::floor_pressure(state.start);
    state.now.alpha = {0.3 * std::cos(3.0 * angle), 0.3 * std::sin(3.0 * angle)};
    const double radius = law.m * p / pm4::sqrt2; // |t|^2 = 2 (d^2 + s^2)
    const double x = radius / pm4::sqrt2;
    const Deviator s = {p * state.now.alpha.d + x * std::cos(angle),
                        p * state.now.alpha.s + x * std::sin(angle)};
    apart.stress = {-p - s.d, -p + s.d, 0.0, -s.s};
    pm4::store(state, apart.variables.data());
    point.set(apart);
    const double turn = (n % 2 == 0 ? 1e-15 : -1e-15);
    const double d = -std::sin(angle) + turn * std::cos(angle);
    const double g = std::cos(angle) + turn * std::sin(angle);
    point.apply({Control::strain(-5e-3 * d), Control::strain(5e-3 * d), Control::strain(-1e-2 * g)});
    ASSERT_EQ(broken_bound(law, point), "") << n;
  }
}

TEST(Pm4Hard, TinyIncrementsAddUp) {
  const Pm4Sand law = report_sand(55);
  PointTest tiny(law, geostatic(100.0 * kilopascal, 0.5));
  PointTest whole(law, geostatic(100.0 * kilopascal, 0.5));
  constexpr int count = 100000;
  for (int n = 0; n < count; ++n) {
    tiny.apply({Control::strain(0.0), Control::strain(-5e-13), Control::strain(1e-12)});
  }
  whole.apply({Control::strain(0.0), Control::strain(-5e-13 * count), Control::strain(1e-12 * count)});
  const double change = std::abs(whole.stress().xy);
  EXPECT_NEAR(tiny.stress().xy, whole.stress().xy, 1e-4 * change);
  EXPECT_NEAR(tiny.stress().yy, whole.stress().yy, 1e-4 * change);
}

TEST(Pm4Hard, IncrementsBeyondTheLimitAreRefusedAndChangeNothing) {
  PointTest point(report_sand(55), geostatic(100.0 * kilopascal, 0.5));
  for (int n = 0; n < 50; ++n) {
    point.apply(shear(1e-5));
  }
  const PointState before = point.now();
  const double nan = std::nan("");
  for (const PointStep& step : {shear(0.1), shear(-0.021), extension(0.1), shear(nan)}) {
    try {
      point.apply(step);
      FAIL() << "not refused";
    } catch (const std::domain_error& error) {
      EXPECT_NE(std::string(error.what()).find("pm4sand: "), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("outside [-0.02, 0.02]"), std::string::npos) << error.what();
    }
    EXPECT_EQ(point.now().variables, before.variables);
    EXPECT_EQ(std::memcmp(&point.now().stress, &before.stress, sizeof(PointStress)), 0);
    EXPECT_EQ(point.plastic_work(), before.plastic_work);
  }
  EXPECT_NO_THROW(point.apply(shear(0.02)));
}

/// Not a number in: refused, naming the point, and nothing has been changed, also of the points before it.
TEST(Pm4Hard, StressOrStateThatIsNotFiniteIsRefusedAndChangesNothing) {
  const Law law = report_sand(55);
  constexpr std::size_t count = 3;
  constexpr std::size_t size = pm4::state_size;
  for (const std::size_t wrong : {std::size_t{1}, std::size_t{4}, std::size_t{10}, 12 + size + 1}) {
    std::vector<double> values(12 + count * size, -100.0 * kilopascal); // sxx, syy, szz, sxy, state
    std::fill_n(values.begin() + 9, 3, 10.0 * kilopascal);
    std::vector<double> work(count);
    const std::vector<double> none(count);
    const std::vector<double> strain(count, 1e-5);
    const Points points{count,       &values[0],  &values[3],  &values[6],    &values[9], &values[12],
                        work.data(), none.data(), none.data(), strain.data(), none.data()};
    initialise(law, points);
    values[wrong] = wrong == 4 ? HUGE_VAL : std::nan("");
    const std::vector<double> before = values;
    try {
      update(law, points);
      FAIL() << "not refused: " << wrong;
    } catch (const std::domain_error& error) {
      EXPECT_NE(std::string(error.what()).find("pm4sand: "), std::string::npos);
      EXPECT_NE(std::string(error.what()).find(" of point 1 is "), std::string::npos) << error.what();
    }
    EXPECT_EQ(std::memcmp(values.data(), before.data(), values.size() * sizeof(double)), 0) << wrong;
    EXPECT_EQ(work, none);
  }
}

/// A finite state from which no finite stress follows: the sub-steps end, and the point stays as it is.
TEST(Pm4Hard, AStateWithoutFiniteStressIsRefusedAndChangesNothing) {
  PointTest point(report_sand(55), geostatic(100.0 * kilopascal, 1.0));
  PointState broken = point.now();
  pm4::State state = pm4::load(broken.variables.data());
  state.start.z_max = 0.0; // fabric over largest fabric is 0/0
  pm4::store(state, broken.variables.data());
  point.set(broken);
  EXPECT_THROW(point.apply(shear(1e-3)), std::domain_error);
  EXPECT_EQ(point.stress().xy, 0.0);
  EXPECT_EQ(point.state(), broken.variables);
}

/// Densities at both ends, K_0 from 0.3 to 2, sigma'_v from 1 kPa to 2 MPa: cycles of strain at constant
/// volume, drained extension, recompression and shear.
TEST(Pm4Hard, AnyDensityAndStress) {
  for (const double D_R : {0.05, 0.35, 0.75, 1.0, 1.2}) {
    const Pm4Sand law = pm4sand({.density = 1900.0,
                                 .relative_density = D_R,
                                 .G_o = 167.0 * std::sqrt(46.0 * D_R * D_R + 2.5),
                                 .h_po = 0.5});
    for (const double K_0 : {0.3, 0.5, 1.0, 2.0}) {
      for (const double sv : {1.0, 10.0, 100.0, 2000.0}) {
        PointTest point(law, geostatic(sv * kilopascal, K_0));
        for (int n = 0; n < 400; ++n) {
          point.apply(shear(shaking(0.01 * (n + 1), 5e-3) - shaking(0.01 * n, 5e-3)));
          ASSERT_EQ(broken_bound(law, point), "") << D_R << " " << K_0 << " " << sv << " " << n;
        }
        EXPECT_LE(pressure(point.stress()), 0.5 * (1.0 + K_0) * sv * kilopascal + 2000.0 * kilopascal);
        for (int n = 0; n < 50; ++n) {
          point.apply(extension(1e-4));
          ASSERT_EQ(broken_bound(law, point), "") << D_R << " " << K_0 << " " << sv;
        }
        for (int n = 0; n < 60; ++n) {
          point.apply({Control::strain(0.0), Control::strain(-1e-4), Control::strain(2e-5)});
          ASSERT_EQ(broken_bound(law, point), "") << D_R << " " << K_0 << " " << sv;
        }
      }
    }
  }
}

/// The same bits however points are grouped into calls.
TEST(Pm4Hard, GroupingChangesNoBit) {
  constexpr std::size_t count = 60;
  const Pm4Sand law = report_sand(55);
  const auto run = [&](std::size_t group) {
    std::vector<double> stress(4 * count);
    std::vector<double> state(count * pm4::state_size);
    std::vector<double> work(count);
    std::vector<double> strain(4 * count);
    const auto view = [&](std::size_t begin, std::size_t size) {
      const auto at = [&](std::vector<double>& values, std::size_t k) { return &values[k * count + begin]; };
      return Points{size,          at(stress, 0), at(stress, 1),
                    at(stress, 2), at(stress, 3), &state[begin * pm4::state_size],
                    &work[begin],  at(strain, 0), at(strain, 1),
                    at(strain, 2), at(strain, 3)};
    };
    for (std::size_t i = 0; i < count; ++i) {
      stress[i] = -(40.0 + static_cast<double>(i)) * kilopascal;
      stress[count + i] = -(50.0 + 2.0 * static_cast<double>(i)) * kilopascal;
    }
    initialise(law, view(0, count));
    for (int n = 0; n < 300; ++n) {
      for (std::size_t i = 0; i < count; ++i) {
        const double phase = 0.05 * n + 0.3 * static_cast<double>(i);
        strain[count + i] = 2e-6 * std::cos(2.0 * phase);
        strain[2 * count + i] = 1e-4 * std::cos(phase);
        strain[3 * count + i] = 1e-4 * std::sin(phase);
      }
      for (std::size_t begin = 0; begin < count; begin += group) {
        update(law, view(begin, std::min(group, count - begin)));
      }
    }
    stress.insert(stress.end(), state.begin(), state.end());
    stress.insert(stress.end(), work.begin(), work.end());
    return stress;
  };
  const std::vector<double> all = run(count);
  for (const std::size_t group : {std::size_t{1}, std::size_t{7}, std::size_t{32}}) {
    const std::vector<double> grouped = run(group);
    EXPECT_EQ(std::memcmp(all.data(), grouped.data(), all.size() * sizeof(double)), 0) << group;
  }
}

} // namespace
} // namespace tremolo::materials::test
