// PM4Sand at its start from a stress, and closed forms of its response.

#include "materials/sand/pm4sand/pm4sand_rates.hpp"
#include "tests/support/pm4sand_soil.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <stdexcept>

namespace tremolo::materials::test {
namespace {

/// The entry of a point's state by the name that its description gives it.
double entry(const PointTest& point, std::string_view name) {
  const auto variables = state_variables(point.law());
  for (std::size_t k = 0; k < variables.size(); ++k) {
    if (variables[k].name == name) {
      return point.state()[k];
    }
  }
  throw std::invalid_argument(std::string(name));
}

/// State parameter of an initial pressure p (Pa) by its definition.
double xi(double p, double D_R) {
  return 1.5 / (10.0 - std::log(100.0 * p / 101.3e3)) - D_R;
}

TEST(Pm4Initial, FollowsFromTheStress) {
  const PointTest point(report_sand(55), geostatic(101.3 * kilopascal, 0.5, 10.0 * kilopascal));
  const double p = 75.975 * kilopascal;
  EXPECT_NEAR(entry(point, "z_max"), 0.7 * std::exp(-6.1 * xi(p, 0.55)), 1e-12);
  EXPECT_NEAR(entry(point, "z_peak"), 1e-5 * entry(point, "z_max"), 1e-18);
  const double M = 2.0 * std::sin(33.0 * std::numbers::pi / 180.0);
  const double M_b = M * std::exp(-0.5 * xi(p, 0.55));
  const double M_d = M * std::exp(0.1 * xi(p, 0.55));
  EXPECT_NEAR(entry(point, "A_do"), 2.5 * (std::asin(0.5 * M_b) - std::asin(0.5 * M)) / (M_b - M_d), 1e-12);
  EXPECT_NEAR(entry(point, "p_min"), 101.3e3 / 200.0, 1e-9);
  EXPECT_NEAR(entry(point, "p_zp"), 0.01 * p, 1e-9);
  EXPECT_NEAR(entry(point, "alpha_xx"), -25.325e3 / p, 1e-12); // compression positive: xx is below the mean
  EXPECT_NEAR(entry(point, "alpha_xy"), -10e3 / p, 1e-12);
  EXPECT_NEAR(entry(point, "alpha_in_true_xy"), -10e3 / p, 1e-12);
  EXPECT_EQ(entry(point, "alpha_in_xy"), 0.0);
  EXPECT_EQ(entry(point, "volumetric_strain"), 0.0);
  EXPECT_NEAR(point.stress().zz, 0.3 * (point.stress().xx + point.stress().yy), 1e-9);
}

TEST(Pm4Initial, KeepsWhatIsGiven) {
  Pm4SandInput input = {.density = 1900.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.4};
  input.A_do = 1.1;
  input.z_max = 5.0;
  const PointTest point(pm4sand(input), geostatic(100.0 * kilopascal, 0.5));
  EXPECT_EQ(entry(point, "A_do"), 1.1);
  EXPECT_EQ(entry(point, "z_max"), 5.0);
}

/// The rule of dense sand ends at the critical state where that of loose sand begins, to its three digits.
TEST(Pm4Initial, DilatancyIsContinuousAtTheCriticalState) {
  const double at_critical = 1.5 / (10.0 - std::log(100.0));
  const auto A_do = [](double D_R) {
    const Pm4Sand law = pm4sand({.density = 1900.0, .relative_density = D_R, .G_o = 500.0, .h_po = 0.5});
    return entry(PointTest(law, geostatic(101.3 * kilopascal, 1.0)), "A_do");
  };
  EXPECT_EQ(A_do(at_critical - 1e-6), 1.24);
  EXPECT_NEAR(A_do(at_critical + 1e-6), 1.24, 0.005);
}

/// A stress outside the bounding surface and one without pressure are reported as they are, from the start
/// on.
TEST(Pm4Initial, HoldsByAnOffsetWhatTheSurfacesCannot) {
  for (const PointStress& stress :
       {geostatic(100.0 * kilopascal, 0.1), geostatic(100.0 * kilopascal, 5.0),
        geostatic(100.0 * kilopascal, 0.5, -60.0 * kilopascal), geostatic(0.2 * kilopascal, 0.5),
        geostatic(0.0, 1.0), geostatic(-3.0 * kilopascal, 1.0)}) {
    PointTest point(report_sand(55), stress);
    const auto offset = [&](const char* name) { return entry(point, name); };
    EXPECT_GT(std::abs(offset("offset_p")) + std::hypot(offset("offset_xx"), offset("offset_xy")), 1.0);
    point.apply({});
    EXPECT_NEAR(point.stress().xx, stress.xx, 1e-9);
    EXPECT_NEAR(point.stress().yy, stress.yy, 1e-9);
    EXPECT_NEAR(point.stress().xy, stress.xy, 1e-9);
    for (int n = 0; n < 100; ++n) {
      point.apply({Control::strain(0.0), Control::strain(-1e-6), Control::strain(1e-6)});
    }
    EXPECT_LT(point.stress().yy, stress.yy); // it resists
  }
}

TEST(Pm4Initial, WithinTheBoundingSurfaceHasNoOffset) {
  for (const double K_0 : {0.4, 0.5, 1.0, 2.0}) {
    const PointTest point(report_sand(55), geostatic(100.0 * kilopascal, K_0, 10.0 * kilopascal));
    EXPECT_EQ(entry(point, "offset_p"), 0.0);
    EXPECT_EQ(entry(point, "offset_xx"), 0.0);
    EXPECT_EQ(entry(point, "offset_xy"), 0.0);
  }
}

TEST(Pm4Initial, RefusesAStressThatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(PointTest(report_sand(55), {-1e3, nan, 0.0, 0.0}), std::invalid_argument);
}

/// The first increment from an isotropic stress is elastic: G and the in-plane bulk stiffness K + G/3.
TEST(Pm4ClosedForm, SmallStrainStiffness) {
  const double p = 150.0 * kilopascal;
  const double G = 677.0 * 101.3e3 * std::sqrt(150.0 / 101.3);
  PointTest sheared(report_sand(55), geostatic(p, 1.0));
  sheared.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(1e-7)});
  EXPECT_NEAR(sheared.stress().xy, 1e-7 * G, 1e-7 * 1e-7 * G);
  PointTest squeezed(report_sand(55), geostatic(p, 1.0));
  squeezed.apply({Control::strain(-5e-8), Control::strain(-5e-8)});
  EXPECT_NEAR(pressure(squeezed.stress()) - p, 1e-7 * 2.5 * G, 1e-4 * 1e-7 * 2.5 * G);
}

/// Isotropic compression: G and K grow with sqrt(p), so that sqrt(p) grows with strain.
TEST(Pm4ClosedForm, IsotropicCompression) {
  const double p = 50.0 * kilopascal;
  PointTest point(report_sand(55), geostatic(p, 1.0));
  for (int n = 0; n < 100; ++n) {
    point.apply({Control::strain(-1e-5), Control::strain(-1e-5)});
  }
  const double root = std::sqrt(p) + 0.5 * 2e-3 * 2.5 * 677.0 * std::sqrt(101.3e3);
  EXPECT_NEAR(pressure(point.stress()), root * root, 1e-4 * root * root);
}

/// At large strain the sand shears at its critical state: drained, it loosens to xi_R = 0 and M_cur meets M.
TEST(Pm4ClosedForm, CriticalState) {
  PointTest point(report_sand(35), geostatic(100.0 * kilopascal, 0.5));
  for (int n = 0; n < 2000; ++n) {
    point.apply({Control::strain(0.0), Control::stress(-100.0 * kilopascal), Control::strain(1e-3)});
  }
  const PointStress& s = point.stress();
  const double M_cur = 2.0 * std::hypot(0.5 * (s.xx - s.yy), s.xy) / pressure(s);
  EXPECT_NEAR(M_cur, 2.0 * std::sin(33.0 * std::numbers::pi / 180.0), 2e-3);
  const Pm4Sand law = report_sand(35);
  const pm4::Surfaces end = pm4::surfaces(law, pressure(s), entry(point, "volumetric_strain"));
  EXPECT_NEAR(end.xi_R, 0.0, 2e-3);
}

/// Work of a closed drained loop at constant pressure is dissipated.
TEST(Pm4ClosedForm, PlasticWorkOfAClosedLoop) {
  PointTest point(report_sand(55), geostatic(100.0 * kilopascal, 1.0));
  double work = 0.0;
  double plastic = 0.0;
  constexpr int quarter = 500;
  constexpr double amplitude = 2e-3;
  for (int n = 0; n < 36 * quarter; ++n) {
    if (n == 33 * quarter) { // the last loop, between two peaks of the strain
      break;
    }
    if (n == 29 * quarter) {
      work = 0.0;
      plastic = point.plastic_work();
    }
    const int sign = ((n + quarter) / (2 * quarter)) % 2 == 0 ? 1 : -1;
    const PointState before = point.now();
    point.apply({Control::stress(-100.0 * kilopascal), Control::stress(-100.0 * kilopascal),
                 Control::strain(sign * amplitude / quarter)});
    const PointState& after = point.now();
    work += 0.5 * (before.stress.xy + after.stress.xy) * (after.strain.xy - before.strain.xy);
    work += -100.0 * kilopascal * (after.strain.xx + after.strain.yy - before.strain.xx - before.strain.yy);
  }
  plastic = point.plastic_work() - plastic;
  EXPECT_GT(work, 0.0);
  EXPECT_NEAR(plastic, work, 0.03 * work);
}

TEST(Pm4ClosedForm, WaveSpeedBound) {
  const Law law = report_sand(55);
  PointTest point(law, geostatic(200.0 * kilopascal, 1.0));
  PointState now = point.now();
  Points points;
  points.count = 1;
  points.sxx = &now.stress.xx;
  points.syy = &now.stress.yy;
  points.state = now.variables.data();
  const double c_s = std::sqrt(677.0 * 101.3e3 * std::sqrt(200.0 / 101.3) / 1900.0);
  EXPECT_NEAR(p_wave_speed_bound(law, points), std::sqrt(3.5) * c_s, 1e-9 * c_s);
}

/// c_p of a small isotropic strain from the point's state: (K + G/3) e_v is the elastic change of p, and
/// K = bulk_ratio G. While there is a gap compression only closes it.
double measured_speed(const Pm4Sand& law, PointTest point) {
  constexpr double strain = 1e-9;
  const double before = point.stress().xy;
  point.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(strain)});
  const double G = std::abs(point.stress().xy - before) / strain;
  return std::sqrt((law.bulk_ratio + 4.0 / 3.0) * G / law.elastic.density);
}

double speed_bound(const Pm4Sand& law, const PointTest& point) {
  PointState now = point.now();
  Points points;
  points.count = 1;
  points.sxx = &now.stress.xx;
  points.syy = &now.stress.yy;
  points.state = now.variables.data();
  return p_wave_speed_bound(law, points);
}

/// Stiffness is kept up by p_min of the initial stress, also where the soil has been pulled to its floor.
TEST(Pm4ClosedForm, WaveSpeedBoundHoldsFromAnyInitialStressDownToTheFloor) {
  const Pm4Sand law = report_sand(55);
  for (const double p_0 : {0.1, 1.0, 10.0, 100.0, 500.0, 2000.0}) {
    PointTest point(law, geostatic(p_0 * kilopascal, 1.0));
    EXPECT_GE(speed_bound(law, point) * (1.0 + 1e-5), measured_speed(law, point)) << p_0;
    for (int n = 0; n < 400; ++n) {
      point.apply({Control::strain(2e-5), Control::strain(2e-5)});
    }
    ASSERT_GT(pm4::load(point.state().data()).now.gap, 0.0) << p_0;
    const double bound = speed_bound(law, point);
    EXPECT_GE(bound * (1.0 + 1e-5), measured_speed(law, point)) << p_0;
    EXPECT_LT(bound, 1.01 * measured_speed(law, point)) << p_0; // no fabric, no shear: it is the speed
  }
}

} // namespace
} // namespace tremolo::materials::test
