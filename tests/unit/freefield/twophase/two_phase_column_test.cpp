// The column of soil and water where another one says the same: without water, without drainage, in total
// stress; its start, its limits, and what it refuses.

#include "freefield/ode/ode_column.hpp"
#include "freefield/twophase/step_limit.hpp"
#include "materials/law/law.hpp"
#include "tests/support/saturated_ground.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

namespace tremolo::freefield::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr std::array levels = {-9.75, -7.25, -3.25, -1.0, 0.0};

Velocity pulse(double time, double frequency = 2.0) {
  const double a = std::pow(std::numbers::pi * frequency * (time - 0.7), 2);
  const double v = 0.1 * (1.0 - 2.0 * a) * std::exp(-a);
  return {v, -0.4 * v};
}

struct Difference {
  double largest = 0.0; ///< of velocity and stress, relative to their peaks
};

/// Marches both columns and compares motion and total stress at all levels.
template <class A, class B>
Difference difference(A& a, B& b, double until) {
  std::array<ColumnSample, levels.size()> of_a, of_b;
  constexpr std::array members = {&ColumnSample::vx, &ColumnSample::vy,  &ColumnSample::ux,
                                  &ColumnSample::uy, &ColumnSample::syy, &ColumnSample::sxy,
                                  &ColumnSample::sxx};
  std::array<double, members.size()> error{}, peak{};
  while (a.time() < until) {
    a.step();
    while (b.time() < a.time() - 0.5 * b.time_step())
      b.step();
    a.sample(levels, of_a);
    b.sample(levels, of_b);
    for (std::size_t m = 0; m < members.size(); ++m)
      for (std::size_t i = 0; i < levels.size(); ++i) {
        error[m] = std::max(error[m], std::abs(of_a[i].*members[m] - of_b[i].*members[m]));
        peak[m] = std::max(peak[m], std::abs(of_b[i].*members[m]));
      }
  }
  Difference found;
  for (std::size_t m = 0; m < members.size(); ++m)
    found.largest = std::max(found.largest, error[m] / peak[m]);
  return found;
}

TEST(TwoPhaseColumn, WithoutWaterIsTheColumnByTheMethodOfLines) {
  const auto elastic = materials::Elasticity::from_wave_speeds(1700.0, 150.0, 300.0);
  Profile profile{
      0.0,
      {layer_of(4.0, materials::MasingShear{elastic, 1e-3, 1.0, 0.9}, 0.02), {6.0, elastic, 0.02}},
      materials::Elasticity::from_wave_speeds(2200.0, 760.0, 1500.0)};
  for (const BaseKind base : {BaseKind::compliant, BaseKind::rigid}) {
    const TwoPhaseSettings settings{
        .max_element_size = 0.5, .time_step = 2e-4, .damping = KelvinVoigtDamping{3.0}, .base = base};
    const auto input = [](double t) { return pulse(t); };
    TwoPhaseColumn elements(profile, settings, input);
    OdeColumnSettings lines{.max_cell_size = 0.125, .time_step = 2e-4};
    lines.relative_tolerance = 1e-7;
    lines.absolute_tolerance = 1e-9;
    lines.damping = settings.damping;
    lines.base = base;
    OdeColumn cells(profile, lines, input);
    EXPECT_LT(difference(elements, cells, 2.0).largest, 1e-2);
  }
}

/// Water that cannot flow: the column of one phase with the constants of both, in total stress.
TEST(TwoPhaseColumn, WithoutFlowIsTheColumnInTotalStress) {
  Profile wet = wet_profile({wet_layer(4.0, 5e7, 1e-12), wet_layer(6.0, 2e8, 1e-12, 0.35)});
  Profile total = wet;
  total.water.reset();
  for (Layer& layer : total.layers) {
    layer.soil = materials::saturated(layer.soil, *layer.pores, water);
    layer.pores.reset();
  }
  const auto input = [](double t) { return pulse(t); };
  auto settings = wet_settings(wet, 0.5);
  settings.base = BaseKind::compliant;
  for (const auto drainage : {materials::Drainage::coupled, materials::Drainage::undrained}) {
    for (Layer& layer : wet.layers)
      layer.pores->drainage = drainage;
    TwoPhaseColumn column(wet, settings, input);
    TwoPhaseColumn reference(total, settings, input);
    EXPECT_LT(difference(column, reference, 1.5).largest, 2e-3) << tremolo::name(drainage);
  }
}

TEST(TwoPhaseColumn, DrainedSoilIsTheSkeletonWithTheMassOfBoth) {
  Profile wet = wet_profile({wet_layer(10.0, 1e8, 1e-4)});
  wet.layers[0].pores->drainage = materials::Drainage::drained;
  Profile skeleton = wet;
  skeleton.water.reset();
  skeleton.layers[0].pores.reset();
  const TwoPhaseSettings settings{.max_element_size = 0.5, .time_step = 1e-3};
  const auto input = [](double t) { return pulse(t); };
  TwoPhaseColumn column(wet, settings, input);
  TwoPhaseColumn reference(skeleton, settings, input);
  EXPECT_LT(difference(column, reference, 2.0).largest, 5e-3);
}

/// Effective stress begins with the weight under water; the table inside the ground or above it.
TEST(TwoPhaseColumn, BeginsWithTheEffectiveStress) {
  materials::Pm4Sand sand =
      materials::pm4sand({.density = 1990.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.4});
  Layer below = layer_of(8.0, sand);
  below.pores = wet_layer(1.0, 1e8, 1e-4).pores;
  sand.elastic.density = 1590.0;
  Profile profile = wet_profile({layer_of(2.0, sand), below});
  profile.water->level = -2.0;
  validate(profile);
  EXPECT_DOUBLE_EQ(profile.hydrostatic_pressure(-5.0), 3.0 * unit_weight);
  const ColumnMesh mesh = mesh_profile(profile, 0.5);
  const ColumnSoil soil(profile, mesh);
  const double overburden = 2.0 * 1590.0 * gravity + 7.75 * 990.0 * gravity;
  EXPECT_NEAR(soil.initial().syy.front(), -overburden, 1e-6 * overburden);
  const double at_rest = 0.3 / 0.7;
  EXPECT_NEAR(soil.initial().sxx.front(), -at_rest * overburden, 1e-6 * overburden);

  // Free water loads the ground, and the pores as much.
  Profile under_sea = wet_profile({below});
  const ColumnSoil dry_shore(under_sea, mesh_profile(under_sea, 0.5));
  under_sea.water->level = 50.0;
  const ColumnSoil sea_bed(under_sea, mesh_profile(under_sea, 0.5));
  EXPECT_NEAR(sea_bed.initial().syy.front(), dry_shore.initial().syy.front(), 1e-6);
}

/// A cavity opens where pressure would fall below that of cavitation and closes before it rises again.
TEST(TwoPhaseColumn, PressureStaysAboveCavitation) {
  Profile profile = wet_profile({wet_layer(2.0, 1e8, 1e-12)});
  auto settings = wet_settings(profile, 0.25);
  constexpr double pull = 3e5; // Pa
  settings.surface_load = [](double time) {
    return pull * std::pow(std::sin(std::numbers::pi * std::clamp(time / 4.0, 0.0, 1.0)), 2);
  };
  TwoPhaseColumn column(profile, settings, at_rest);
  double lowest = 0.0;
  while (column.time() < 4.1) {
    column.step();
    // Total pressure at the centre of an element, y = -1.125 m.
    const double total = sample_at(column, -1.125).pore_pressure + 1.125 * unit_weight;
    lowest = std::min(lowest, total);
    ASSERT_GE(total, water.cavitation_pressure * (1.0 + 1e-12));
  }
  EXPECT_NEAR(lowest, water.cavitation_pressure, 1.0);
  // The cavity has closed: pressure rings about zero. Pressure that were cut as a state would stay high by
  // what was cut, some 200 kPa.
  double sum = 0.0;
  int count = 0;
  for (; column.time() < 4.6; ++count) {
    column.step();
    sum += sample_at(column, -1.125).pore_pressure;
  }
  EXPECT_NEAR(sum / count, 0.0, 0.05 * pull);
}

/// Whatever the law: shaken over yield, it stays bounded, and water leaves after.
TEST(TwoPhaseColumn, TakesEveryLaw) {
  const auto pores = *wet_layer(1.0, 1e8, 1e-3).pores;
  const materials::Elasticity elastic{materials::saturated_density(pores, water), 80e6, 0.3, 0.5};
  const std::vector<materials::Law> laws = {
      materials::LinearElastic{elastic},
      materials::MohrCoulomb{.elastic = elastic,
                             .cohesion_peak = 2e3,
                             .cohesion_residual = 2e3,
                             .friction_peak = 0.6,
                             .friction_residual = 0.6},
      materials::DruckerPrager{.elastic = elastic, .cohesion = 2e3, .friction = 0.6},
      materials::MasingShear{elastic, 5e-4, 1.0, 0.9},
      materials::iwan_shear(elastic, 5e-4, 1.0, 0.9),
      materials::multi_yield_clay(elastic, 40e3),
      materials::pm4sand({.density = elastic.density, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.4}),
      materials::pdmy03({.relative_density = 0.57, .density = elastic.density})};
  ASSERT_EQ(laws.size(), std::variant_size_v<materials::Laws>);
  for (const materials::Law& law : laws) {
    SCOPED_TRACE(materials::name(law));
    Layer layer = layer_of(10.0, law, 0.005);
    layer.pores = pores;
    const Profile profile = wet_profile({layer});
    const Damping damping = KelvinVoigtDamping{5.0};
    const TwoPhaseSettings settings{.max_element_size = 0.5,
                                    .time_step = 0.8 * two_phase_step_limit(profile, 0.5, damping, 2.0),
                                    .damping = damping};
    TwoPhaseColumn column(profile, settings, [](double t) { return Velocity{2.0 * pulse(t).x, 0.0}; });
    double fastest = 0.0;
    while (column.time() < 3.0) {
      column.step();
      fastest = std::max(fastest, std::abs(sample_at(column, 0.0).vx));
    }
    EXPECT_GT(fastest, 0.15);
    EXPECT_LT(fastest, 2.0);
    const double pressure = sample_at(column, -5.0).pore_pressure;
    march(column, 10.0);
    EXPECT_LE(std::abs(sample_at(column, -5.0).pore_pressure), std::abs(pressure) + 100.0);
    EXPECT_LT(std::abs(sample_at(column, 0.0).vx), 0.02);
  }
}

TEST(TwoPhaseColumn, WaterDoesNotPassIntoTightSoil) {
  auto tight = wet_layer(2.0, 1e8, 1e-4);
  tight.pores->drainage = materials::Drainage::undrained;
  const Profile profile = wet_profile({tight, wet_layer(2.0, 1e8, 1e-2)});
  auto settings = wet_settings(profile, 0.5);
  settings.surface_load = [](double time) { return -1e4 * std::clamp(time / 0.1, 0.0, 1.0); };
  TwoPhaseColumn column(profile, settings, at_rest);
  march(column, 5.0);
  EXPECT_EQ(column.flux()[4], 0.0);
  double mean = 0.0;
  for (const double y : evenly(-3.75, -2.25, 0.5))
    mean += 0.25 * sample_at(column, y).pore_pressure;
  EXPECT_NEAR(mean, 1e4 * 5.5e9 / (5.5e9 + 1e8), 300.0); // nothing drains below
}

TEST(TwoPhaseColumn, StopsBeforePoresClose) {
  // exp(-0.5) of the volume at rest holds less than the grains, 0.7 of it.
  const Profile profile = wet_profile({wet_layer(1.0, 1e6, 1e-2, 0.3)});
  auto settings = wet_settings(profile, 0.25, 0.1);
  settings.surface_load = [](double time) { return -5e5 * std::clamp(time / 0.1, 0.0, 1.0); };
  TwoPhaseColumn column(profile, settings, at_rest);
  EXPECT_THAT([&] { march(column, 5.0); }, ThrowsMessage<std::runtime_error>(AllOf(
                                               HasSubstr("its porosity is 0.00"), HasSubstr("from 0.3;"),
                                               HasSubstr("must stay in [0.01, 0.95]"))));
}

TEST(TwoPhaseColumn, StepIsLimitedByTheFastWaveAlone) {
  const auto limit = [](double permeability) {
    return two_phase_step_limit(wet_profile({wet_layer(10.0, 1e8, permeability)}), 0.5, Damping{});
  };
  const double fast = materials::saturated_speeds(1e8, *wet_layer(1.0, 1e8, 1.0).pores, water).fast;
  for (const double permeability : {1e-1, 1e-5, 1e-9})
    EXPECT_NEAR(limit(permeability), 0.5 / fast, 1e-9);
}

TEST(TwoPhaseColumn, RefusesWhatItCannotMarch) {
  const Profile profile = wet_profile({wet_layer(10.0, 1e8, 1e-4)});
  auto settings = wet_settings(profile, 0.5);
  settings.time_step *= 1.3;
  EXPECT_THAT([&] { TwoPhaseColumn(profile, settings, at_rest); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("the stability limit of central differences")));
  Profile weightless = profile;
  weightless.gravity = 0.0;
  EXPECT_THAT([&] { TwoPhaseColumn(weightless, wet_settings(profile, 0.5), at_rest); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("gravity where water flows")));
  Profile waterless = profile;
  waterless.water.reset();
  EXPECT_THAT([&] { validate(waterless); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("no water table")));
  Profile high = profile;
  high.water->level = -3.0;
  EXPECT_THAT([&] { validate(high); }, ThrowsMessage<std::invalid_argument>(HasSubstr("water table, -3 m")));
}

} // namespace
} // namespace tremolo::freefield::testing
