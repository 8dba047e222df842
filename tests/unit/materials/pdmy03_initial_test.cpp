// PDMY03: the state made from a stress, its description, and the bound of the wave speed.

#include "materials/law/law.hpp"
#include "materials/sand/pdmy03/pdmy03_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace tremolo::materials {
namespace {

using Place = pdmy03_state::Place;

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
  EXPECT_EQ(point.state[Place::active_surface], 11.0);
  EXPECT_EQ(point.state[Place::zone], -1.0);
  EXPECT_NEAR(point.state[Place::largest_pressure], 202e3 / 3.0, 1e-9);
  Point isotropic(law, -1e5, -1e5, -1e5, 0.0);
  EXPECT_EQ(isotropic.state[Place::active_surface], 0.0);
}

TEST(Pdmy03Initial, SurfacesThatTheStressHasPassedTouchIt) {
  const Pdmy03 law = pdmy03({.relative_density = 0.33});
  Point point(law, -50.5e3, -101e3, -50.5e3, 5e3);
  Pdmy03Memory memory(point.state.data());
  const MeanAndDeviator stress = split(point.sxx, point.syy, point.szz, point.sxy);
  const double height = law.residual_pressure - stress.mean;
  const auto active = static_cast<std::size_t>(point.state[Place::active_surface]);
  ASSERT_GT(active, 5U);
  for (std::size_t i = 1; i <= active; ++i) {
    const Deviator3 centre =
        i == active ? memory.deviator(Place::active_centre) : memory.resting_centre(i, law.surfaces);
    const double distance = std::sqrt(1.5) * norm(stress.deviator + height * centre);
    EXPECT_NEAR(distance / (law.ratio[i] * height), 1.0, 1e-5) << i;
  }
  EXPECT_EQ(norm(memory.resting_centre(active + 1, law.surfaces)), 0.0);
}

TEST(Pdmy03Initial, RemembersTheElasticStrainOfGravity) {
  const Pdmy03 law = pdmy03({.relative_density = 0.74});
  Point point(law, -40e3, -100e3, -60e3, 10e3);
  const double shear = law.elastic.shear_modulus();
  EXPECT_NEAR(point.state[Place::volume_strain], -200e3 / (3.0 * law.elastic.bulk_modulus()), 1e-12);
  // deviators: zz and xy components of s/(2 G), orthonormal
  EXPECT_NEAR(point.state[Place::strain + 1], std::sqrt(1.5) * (-60e3 + 200e3 / 3.0) / (2.0 * shear), 1e-12);
  EXPECT_NEAR(point.state[Place::strain + 2], std::sqrt(2.0) * 10e3 / (2.0 * shear), 1e-12);
}

TEST(Pdmy03Initial, AStressOutsideTheConeIsScaledOntoIt) {
  const Pdmy03 law = pdmy03({.relative_density = 0.33});
  const double failure = law.ratio[law.surfaces];
  Point steep(law, -20e3, -100e3, -20e3, 30e3); // K0 = 0.2
  EXPECT_NEAR(steep.q(), failure * (law.residual_pressure - steep.mean()), 1e-6);
  EXPECT_NEAR(steep.mean(), -140e3 / 3.0, 1e-6);
  EXPECT_EQ(steep.state[Place::active_surface], static_cast<double>(law.surfaces));
  EXPECT_GT(steep.sxy, 0.0);
}

TEST(Pdmy03Initial, TensionIsCut) {
  const Pdmy03 law = pdmy03({.relative_density = 0.57});
  Point tension(law, 10e3, 20e3, 5e3, 1e3);
  EXPECT_NEAR(tension.mean(), 0.0, 1e-9);
  EXPECT_LE(tension.q(), law.ratio[law.surfaces] * law.residual_pressure * (1.0 + 1e-12));
  EXPECT_EQ(tension.state[Place::gap], 0.0);
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
    EXPECT_EQ(variables[Place::active_surface].name, "active_surface");
    EXPECT_EQ(variables[Place::zone].name, "dilation_zone");
    EXPECT_EQ(variables[Place::damage].name, "damage");
    EXPECT_EQ(variables[Place::gap].name, "gap");
    EXPECT_EQ(variables[Place::strain].name, "strain_deviator_a");
    EXPECT_EQ(variables[Place::pivot_direction + 2].name, "zone_direction_c");
    EXPECT_EQ(variables[Place::centres].name, "centres_01");
    EXPECT_FALSE(variables[Place::gap].internal);
    EXPECT_TRUE(variables[Place::centres].internal);
  }
}

TEST(Pdmy03Initial, CentresKeepSinglePrecisionAndAreNeverNotNumbers) {
  std::vector<double> block(pdmy03_state_size(20), 0.0);
  Pdmy03Memory memory(block.data());
  for (std::size_t i = 1; i < 20; ++i) {
    const double x = static_cast<double>(i);
    memory.rest_centre(i, {1.0 / x, -0.3 * x, -1e-30 * x});
  }
  for (const double value : block) {
    EXPECT_TRUE(std::isfinite(value));
  }
  for (std::size_t i = 1; i < 20; ++i) {
    const double x = static_cast<double>(i);
    EXPECT_NEAR(memory.resting_centre(i, 20).a * x, 1.0, 1e-7);
    EXPECT_NEAR(memory.resting_centre(i, 20).b / x, -0.3, 1e-7);
  }
  EXPECT_EQ(norm(memory.resting_centre(20, 20)), 0.0); // the failure surface
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
