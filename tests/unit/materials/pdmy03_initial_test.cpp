// PDMY03: the state made from a stress, its description, and the bound of the wave speed.

#include "materials/law/law.hpp"
#include "materials/sand/pdmy03/pdmy03_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace tremolo::materials {
namespace {

/// One point with a stress, initialised.
struct Point {
  Pdmy03 law;
  double sxx, syy, szz, sxy;
  double work = 0.0;
  double dexx = 0.0, deyy = 0.0, dgxy = 0.0, dwxy = 0.0;
  std::vector<double> state;

  Point(const Pdmy03& of, double xx, double yy, double zz, double xy)
      : law(of), sxx(xx), syy(yy), szz(zz), sxy(xy), state(state_variables(law).size()) {
    initialise(law, points());
  }
  Pdmy03State now() const { return load_pdmy03(state.data()); }
  Points points() { return {1, &sxx, &syy, &szz, &sxy, state.data(), &work, &dexx, &deyy, &dgxy, &dwxy}; }
  double mean() const { return (sxx + syy + szz) / 3.0; }
  double q() const {
    const double m = mean();
    return std::sqrt(
        1.5 * ((sxx - m) * (sxx - m) + (syy - m) * (syy - m) + (szz - m) * (szz - m) + 2.0 * sxy * sxy));
  }
};

TEST(Pdmy03Initial, AStressInsideTheConeIsKeptAndFindsItsSurface) {
  const Pdmy03 law = pdmy03({.relative_density = 0.57});
  Point point(law, -50.5e3, -101e3, -50.5e3, 0.0);
  EXPECT_EQ(point.sxx, -50.5e3);
  EXPECT_EQ(point.syy, -101e3);
  // eta = 50.5/(67.33 + p_res) lies between surfaces 11 and 12 of M_f i/20
  EXPECT_EQ(point.now().active_surface, 11.0);
  EXPECT_EQ(point.now().zone, -1.0);
  EXPECT_NEAR(point.now().largest_pressure, 202e3 / 3.0, 1e-9);
  Point isotropic(law, -1e5, -1e5, -1e5, 0.0);
  EXPECT_EQ(isotropic.now().active_surface, 0.0);
}

TEST(Pdmy03Initial, SurfacesThatTheStressHasPassedTouchIt) {
  const Pdmy03 law = pdmy03({.relative_density = 0.33});
  Point point(law, -50.5e3, -101e3, -50.5e3, 5e3);
  const Pdmy03State state = point.now();
  const RestingCentres resting(point.state.data(), law.surfaces);
  const MeanAndDeviator stress = split(point.sxx, point.syy, point.szz, point.sxy);
  const double height = law.residual_pressure - stress.mean;
  const auto active = static_cast<std::size_t>(state.active_surface);
  ASSERT_GT(active, 5U);
  for (std::size_t i = 1; i <= active; ++i) {
    const Deviator3 centre = i == active ? state.active_centre : resting[i];
    const double distance = std::sqrt(1.5) * norm(stress.deviator + height * centre);
    EXPECT_NEAR(distance / (law.ratio[i] * height), 1.0, 1e-5) << i;
  }
  EXPECT_EQ(norm(resting[active + 1]), 0.0);
}

TEST(Pdmy03Initial, RemembersTheElasticStrainOfGravity) {
  const Pdmy03 law = pdmy03({.relative_density = 0.74});
  Point point(law, -40e3, -100e3, -60e3, 10e3);
  const double shear = law.elastic.shear_modulus();
  EXPECT_NEAR(point.now().volume_strain, -200e3 / (3.0 * law.elastic.bulk_modulus()), 1e-12);
  // deviators: zz and xy components of s/(2 G), orthonormal
  EXPECT_NEAR(point.now().strain.b, std::sqrt(1.5) * (-60e3 + 200e3 / 3.0) / (2.0 * shear), 1e-12);
  EXPECT_NEAR(point.now().strain.c, std::sqrt(2.0) * 10e3 / (2.0 * shear), 1e-12);
}

TEST(Pdmy03Initial, AStressOutsideTheConeIsScaledOntoIt) {
  const Pdmy03 law = pdmy03({.relative_density = 0.33});
  const double failure = law.ratio[law.surfaces];
  Point steep(law, -20e3, -100e3, -20e3, 30e3); // K0 = 0.2
  EXPECT_NEAR(steep.q(), failure * (law.residual_pressure - steep.mean()), 1e-6);
  EXPECT_NEAR(steep.mean(), -140e3 / 3.0, 1e-6);
  EXPECT_EQ(steep.now().active_surface, static_cast<double>(law.surfaces));
  EXPECT_GT(steep.sxy, 0.0);
}

TEST(Pdmy03Initial, TensionIsCut) {
  const Pdmy03 law = pdmy03({.relative_density = 0.57});
  Point tension(law, 10e3, 20e3, 5e3, 1e3);
  EXPECT_NEAR(tension.mean(), 0.0, 1e-9);
  EXPECT_LE(tension.q(), law.ratio[law.surfaces] * law.residual_pressure * (1.0 + 1e-12));
  EXPECT_EQ(tension.now().gap, 0.0);
}

TEST(Pdmy03Initial, StateIsDescribed) {
  for (const double surfaces : {3.0, 20.0, 21.0, 40.0}) {
    const Law law = pdmy03({.relative_density = 0.57, .surfaces = surfaces});
    const auto variables = state_variables(law);
    EXPECT_EQ(variables.size(), pdmy03_state_size(static_cast<std::size_t>(surfaces)));
    std::set<std::string> names;
    for (const StateVariable& variable : variables) {
      EXPECT_TRUE(names.insert(std::string(variable.name)).second) << variable.name;
      EXPECT_FALSE(variable.unit.empty());
      EXPECT_FALSE(variable.meaning.empty());
    }
    const auto described = [&](std::size_t offset) { return variables[offset / sizeof(double)].name; };
    EXPECT_EQ(described(offsetof(Pdmy03State, active_surface)), "active_surface");
    EXPECT_EQ(described(offsetof(Pdmy03State, zone)), "dilation_zone");
    EXPECT_EQ(described(offsetof(Pdmy03State, damage)), "damage");
    EXPECT_EQ(described(offsetof(Pdmy03State, gap)), "gap");
    EXPECT_EQ(described(offsetof(Pdmy03State, strain)), "strain_deviator_a");
    EXPECT_EQ(described(offsetof(Pdmy03State, pivot_direction.c)), "zone_direction_c");
    EXPECT_EQ(described(sizeof(Pdmy03State)), "centres_01");
    EXPECT_FALSE(variables[offsetof(Pdmy03State, gap) / sizeof(double)].internal);
    EXPECT_TRUE(variables[pdmy03_fixed_size].internal);
  }
}

TEST(Pdmy03Initial, CentresKeepSinglePrecisionAndAreNeverNotNumbers) {
  std::vector<double> block(pdmy03_state_size(20), 0.0);
  const RestingCentres resting(block.data(), 20);
  for (std::size_t i = 1; i < 20; ++i) {
    const double x = static_cast<double>(i);
    resting.set(i, {1.0 / x, -0.3 * x, -1e-30 * x});
  }
  for (const double value : block) {
    EXPECT_TRUE(std::isfinite(value));
  }
  for (std::size_t i = 1; i < 20; ++i) {
    const double x = static_cast<double>(i);
    EXPECT_NEAR(resting[i].a * x, 1.0, 1e-7);
    EXPECT_NEAR(resting[i].b / x, -0.3, 1e-7);
  }
  EXPECT_EQ(norm(resting[20]), 0.0); // the failure surface
}

TEST(Pdmy03Initial, ElasticLoadingInsideTheCoreHasTheModulusOfItsPressure) {
  const Pdmy03 law = pdmy03({.relative_density = 0.57});
  for (const double p : {10e3, 101e3, 400e3}) {
    Point point(law, -p, -p, -p, 0.0);
    point.dgxy = 1e-7;
    update(law, point.points());
    const double modulus = 73.7e6 * std::sqrt((p + law.residual_pressure) / (101e3 + law.residual_pressure));
    EXPECT_NEAR(point.sxy, modulus * 1e-7, 1e-9 * modulus * 1e-7);
    EXPECT_EQ(point.work, 0.0);
  }
}

TEST(Pdmy03Initial, TheWaveSpeedBoundIsThatOfTheLargestPressure) {
  const Pdmy03 law = pdmy03({.relative_density = 0.57});
  double xx[] = {-101e3, -404e3, 0.0};
  double yy[] = {-101e3, -404e3, 0.0};
  double zz[] = {-101e3, -404e3, 0.0};
  Points points;
  points.count = 3;
  points.sxx = xx;
  points.syy = yy;
  points.szz = zz;
  const double elastic = std::sqrt((196.8e6 + 4.0 / 3.0 * 73.7e6) / 1990.0);
  const double residual = law.residual_pressure;
  EXPECT_NEAR(p_wave_speed_bound(Law(law), points),
              elastic * std::pow((404e3 + residual) / (101e3 + residual), 0.25), 1e-6);
  points.count = 1;
  EXPECT_NEAR(p_wave_speed_bound(Law(law), points), elastic, 1e-6);
}

TEST(Pdmy03Initial, OutOfPlaneStrainIsTaken) {
  const Pdmy03 law = pdmy03({.relative_density = 0.57});
  Point point(law, -100e3, -100e3, -100e3, 0.0);
  const double axial = -1e-7;
  Points points = point.points();
  points.dezz = &axial;
  update(law, points);
  EXPECT_LT(point.szz, point.sxx);
  EXPECT_NEAR(point.sxx, point.syy, 1e-9);
  EXPECT_TRUE(traits(law).three_dimensional);
}

} // namespace
} // namespace tremolo::materials
