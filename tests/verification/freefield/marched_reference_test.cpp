// The marched column at an angle against exact solutions: dry and undrained layers by the frequency domain's
// exact field, layers with two phases by reference data made from Biot's equations; and cohesive soil that
// yields against a two-dimensional finite-element strip.

#include "freefield/marched/marched_column.hpp"
#include "tests/support/oblique_march.hpp"
#include "wavefield/layers/layered_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

namespace {

using namespace tremolo;
using namespace tremolo::freefield;
using namespace tremolo::freefield::testing;
using materials::Drainage;

/// Elements change their length as they strain, which exact solutions do not: small motion.
constexpr double peak = 5e-5; // m/s
const std::function<double(double)> pulse = [](double t) { return ricker(t, 5.0, 0.4, peak); };

/// Levels from the base (0) to the surface.
constexpr std::array<double, 5> levels = {0.0, 5.0, 10.0, 15.0, 20.0};

wavefield::LayeredHalfSpace as_layers(const Profile& profile) {
  const auto& base = profile.half_space;
  wavefield::LayeredHalfSpace ground{.half_space = {base.density, base.s_wave_speed(), base.p_wave_speed()}};
  for (const Layer& layer : profile.layers) {
    const materials::Elasticity soil =
        layer.pores ? materials::saturated(layer.soil, *layer.pores, profile.water->fluid) : layer.soil;
    ground.layers.push_back({.thickness = layer.thickness,
                             .density = soil.density,
                             .vs = soil.s_wave_speed(),
                             .vp = soil.p_wave_speed()});
  }
  return ground;
}

/// Relative errors of vx and vy at the surface, and the worst over levels of all velocities and stresses.
struct Errors {
  double vx = 0.0, vy = 0.0, worst = 0.0;
};

Errors against_layers(const Profile& profile, const PlaneWave& wave, double h) {
  constexpr double interval = 0.0025;
  constexpr std::size_t times = 800;
  const wavefield::Signal signal = wavefield::ricker(5.0, 0.4, peak);
  const auto type = wave.shear ? wavefield::WaveType::SV : wavefield::WaveType::P;
  const wavefield::LayeredField field(as_layers(profile), {type, wave.angle_deg * degree, 0.0, 0.0}, 20.0,
                                      signal);
  std::vector<wavefield::Point> points;
  for (const double y : levels)
    points.push_back({0.0, y});
  const auto exact = field.sample(points, {interval, interval, times});

  MarchedColumn column = marched(profile, wave, h, interval);
  std::array<ColumnSample, levels.size()> samples;
  std::array<std::array<RelativeError, 5>, levels.size()> errors;
  for (std::size_t i = 0; i < times; ++i) {
    march_to(column, interval * static_cast<double>(i + 1));
    column.sample(levels, samples);
    for (std::size_t k = 0; k < levels.size(); ++k) {
      const ColumnSample& s = samples[k];
      const wavefield::History& e = exact[k];
      errors[k][0].add(s.vx, e.vx[i]);
      errors[k][1].add(s.vy, e.vy[i]);
      errors[k][2].add(s.sxx, e.sxx[i]);
      errors[k][3].add(s.syy, e.syy[i]);
      errors[k][4].add(s.sxy, e.sxy[i]);
    }
  }
  Errors result{errors.back()[0].value(), errors.back()[1].value(), 0.0};
  for (std::size_t k = 0; k < levels.size(); ++k)
    for (std::size_t q = 0; q < (k + 1 == levels.size() ? 2U : 5U); ++q) // no traction at the surface
      result.worst = std::max(result.worst, errors[k][q].value());
  std::printf("h %.3f: vx %.2e, vy %.2e, worst %.2e, %.2f evaluations a step\n", h, result.vx, result.vy,
              result.worst, column.evaluations_per_step());
  EXPECT_EQ(column.unconverged_steps(), 0);
  return result;
}

struct Wave {
  const char* name;
  double angle_deg;
  bool shear;
};

class MarchedAgainstLayers : public ::testing::TestWithParam<Wave> {};

TEST_P(MarchedAgainstLayers, DrySoilIsOfSecondOrder) {
  const PlaneWave wave{GetParam().angle_deg, GetParam().shear, pulse};
  const Errors coarse = against_layers(dry_ground(), wave, 0.5);
  const Errors fine = against_layers(dry_ground(), wave, 0.25);
  EXPECT_GT(std::log2(coarse.vx / fine.vx), 1.9);
  EXPECT_GT(std::log2(coarse.vy / fine.vy), 1.9);
  EXPECT_LT(fine.worst, 2.5e-3);
}

INSTANTIATE_TEST_SUITE_P(, MarchedAgainstLayers,
                         ::testing::Values(Wave{"SV15", 15.0, true}, Wave{"SV10", 10.0, true},
                                           Wave{"P20", 20.0, false}),
                         [](const auto& wave) { return wave.param.name; });

TEST(MarchedColumn, UndrainedSoilIsOfSecondOrder) {
  const PlaneWave wave{15.0, true, pulse};
  const Errors coarse = against_layers(wet_ground(Drainage::undrained), wave, 0.5);
  const Errors fine = against_layers(wet_ground(Drainage::undrained), wave, 0.25);
  EXPECT_GT(std::log2(coarse.vx / fine.vx), 1.9);
  EXPECT_GT(std::log2(coarse.vy / fine.vy), 1.8);
  EXPECT_LT(fine.worst, 2e-3);
}

/// Errors of the columns of a reference file that are named.
Errors against_biot(const std::vector<std::vector<double>>& rows, double h) {
  const PlaneWave wave{15.0, true, pulse};
  MarchedColumn column = marched(wet_ground(), wave, h, rows[0][0]);
  constexpr std::array<double, 5> y = {20.0, 15.0, 10.0, 5.0, 0.0}; // depths 0, 5, 10, 15, 20 m
  std::array<ColumnSample, y.size()> samples;
  // t; vxm, vym, vx, vy at the surface; vxm, vym, sxx, syy, sxy, p at three depths; vxm, vym at the base
  std::array<RelativeError, 22> errors;
  for (const std::vector<double>& row : rows) {
    march_to(column, row[0]);
    column.sample(y, samples);
    std::vector<double> computed = {samples[0].vx, samples[0].vy};
    std::vector<double> exact = {row[1], row[2]};
    for (std::size_t k = 1; k < 4; ++k) {
      const ColumnSample& s = samples[k];
      computed.insert(computed.end(), {s.vx, s.vy, s.sxx, s.syy, s.sxy, s.pore_pressure});
      const auto first = row.begin() + 5 + static_cast<std::ptrdiff_t>(6 * (k - 1));
      exact.insert(exact.end(), first, first + 6);
    }
    computed.insert(computed.end(), {samples[4].vx, samples[4].vy});
    exact.insert(exact.end(), {row[23], row[24]});
    constexpr double peak_of_reference = 0.5;
    for (std::size_t q = 0; q < errors.size(); ++q)
      errors[q].add(computed[q] * peak_of_reference / peak, exact[q]);
  }
  Errors result{errors[0].value(), errors[1].value(), 0.0};
  for (const RelativeError& error : errors)
    result.worst = std::max(result.worst, error.value());
  std::printf("h %.3f: vx %.2e, vy %.2e, worst %.2e, %.2f evaluations a step\n", h, result.vx, result.vy,
              result.worst, column.evaluations_per_step());
  return result;
}

TEST(MarchedColumn, TwoPhasesAgreeWithBiotsEquations) {
  const auto rows =
      tremolo::testing::read_table(tremolo::testing::reference_folder() / "oblique/elastic_wet_15.csv");
  if (rows.empty())
    GTEST_SKIP() << "no reference data";
  const Errors coarse =
      against_biot(rows, 0.25); // coarser elements do not resolve the layer of flow at the surface
  const Errors fine = against_biot(rows, 0.125);
  EXPECT_GT(std::log2(coarse.vx / fine.vx), 1.8);
  EXPECT_LT(coarse.worst, 3e-3);
}

Layer cohesive(double thickness, double density, double vs, double poisson, double strength) {
  materials::Elasticity soil = elastic(density, vs, poisson);
  soil.at_rest = 0.9;
  return layer_of(thickness, materials::DruckerPrager{.elastic = soil, .cohesion = strength});
}

TEST(MarchedColumn, CohesiveSoilThatYieldsAgreesWithAStripInTwoDimensions) {
  const auto rows = tremolo::testing::read_table(tremolo::testing::reference_folder() /
                                                 "oblique/nonlinear_2d_cohesive_15_h025.csv");
  if (rows.empty())
    GTEST_SKIP() << "no reference data";
  const Profile profile{
      .surface_level = 20.0,
      .layers = {cohesive(6.0, 1800.0, 150.0, 0.3, 40e3), cohesive(14.0, 2000.0, 250.0, 0.35, 75e3)},
      .half_space = rock(),
      .gravity = 9.81};
  const PlaneWave wave{15.0, true, [](double t) {
                         constexpr double pi = std::numbers::pi;
                         return t > 0.05 && t < 1.35 ? 0.25 * std::pow(std::sin((t - 0.05) * pi / 1.3), 2) *
                                                           std::sin(6.0 * pi * (t - 0.7) + 0.7)
                                                     : 0.0;
                       }};
  MarchedColumn column = marched(profile, wave, 0.25, 0.0025);
  constexpr std::array<double, 5> y = {0.0, 5.0, 10.0, 15.0, 20.0};
  std::array<ColumnSample, y.size()> samples;
  std::array<RelativeError, 4> velocity;
  RelativeError stress;
  for (const std::vector<double>& row : rows) {
    march_to(column, row[0]);
    column.sample(y, samples);
    velocity[0].add(samples[4].vx, row[1]);
    velocity[1].add(samples[4].vy, row[2]);
    velocity[2].add(samples[0].vx, row[3]);
    velocity[3].add(samples[0].vy, row[4]);
    for (std::size_t k = 0; k < 3; ++k) {
      stress.add(samples[k + 1].sxx, row[5 + 3 * k]);
      stress.add(samples[k + 1].syy, row[6 + 3 * k]);
      stress.add(samples[k + 1].sxy, row[7 + 3 * k]);
    }
  }
  std::printf(
      "vx %.2e, vy %.2e, base %.2e %.2e, stress %.2e; %.2f evaluations a step, %ld unconverged, %.1e\n",
      velocity[0].value(), velocity[1].value(), velocity[2].value(), velocity[3].value(), stress.value(),
      column.evaluations_per_step(), column.unconverged_steps(), column.largest_residual());
  EXPECT_LT(velocity[0].value(), 0.025);
  EXPECT_LT(velocity[1].value(), 0.01);
  EXPECT_LT(velocity[2].value(), 0.003);
  EXPECT_LT(velocity[3].value(), 0.003);
  EXPECT_LT(stress.value(), 0.015);
}

} // namespace
