#include "freefield/ode/ode_column.hpp"
#include "freefield/ode/ode_soil.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace {

using namespace tremolo::freefield;
using testing::HasSubstr;
using tremolo::materials::Backbone;
using tremolo::materials::Elasticity;

const Elasticity soil = Elasticity::from_wave_speeds(1800.0, 200.0, 400.0);

OdeColumnSettings settings() {
  OdeColumnSettings s;
  s.max_cell_size = 1.0;
  s.time_step = 0.01;
  return s;
}

std::string refusal(const Profile& profile, const OdeColumnSettings& s) {
  try {
    const OdeColumn column(profile, s, [](double) { return Velocity{}; });
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(OdeColumn, RefusesValuesOutsideTheirRange) {
  const Profile profile{.layers = {{10.0, soil}}, .half_space = soil};
  EXPECT_EQ(refusal(profile, settings()), "");
  auto s = settings();
  s.relative_tolerance = 0.0;
  EXPECT_THAT(refusal(profile, s), HasSubstr("relative tolerance is 0"));
  s = settings();
  s.absolute_tolerance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(profile, s), HasSubstr("absolute tolerance"));
  s = settings();
  s.max_step = -1.0;
  EXPECT_THAT(refusal(profile, s), HasSubstr("longest step"));
}

TEST(OdeColumn, NamesTheModelThatTakesALawItDoesNot) {
  tremolo::materials::MohrCoulomb law;
  law.elastic = soil;
  law.cohesion_peak = law.cohesion_residual = 1e4;
  EXPECT_THAT(refusal({.layers = {layer_of(10.0, law)}, .half_space = soil}, settings()),
              testing::AllOf(HasSubstr("layer 1"), HasSubstr("mohr_coulomb"), HasSubstr("`fe` takes it")));
}

TEST(OdeColumn, SaysWhenAndWhereItStopped) {
  for (const OdeMethod method :
       {OdeMethod::adams, OdeMethod::bdf, OdeMethod::explicit_runge_kutta, OdeMethod::imex}) {
    auto s = settings();
    s.method = method;
    OdeColumn column({.layers = {{10.0, soil}}, .half_space = soil}, s, [](double t) {
      return Velocity{t < 0.1 ? 0.0 : std::numeric_limits<double>::quiet_NaN(), 0.0};
    });
    try {
      while (column.time() < 0.3) {
        column.step();
      }
      ADD_FAILURE() << "no exception";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(),
                  testing::AllOf(HasSubstr("beyond t = 0."), HasSubstr("no finite value at y = -10 m")))
          << static_cast<int>(method);
    }
  }
}

TEST(OdeColumn, AtRestCostsNothingAndTheFirstInputIsNotMissed) {
  const Profile profile{.layers = {{10.0, soil}}, .half_space = soil};
  auto s = settings();
  const OdeStatistics idle = [&] {
    OdeColumn column(profile, s, [](double) { return Velocity{}; });
    while (column.time() < 1.0) {
      column.step();
    }
    return column.statistics();
  }();
  EXPECT_EQ(idle.right_hand_sides, 0);

  // Shear from 0.513 s on, no dilation: the surface doubles the incident wave 10 m / 200 m/s later.
  constexpr double start = 0.513, travel = 0.05;
  s.max_cell_size = 0.1;
  OdeColumn column(profile, s, [](double t) {
    return Velocity{t < start ? 0.0 : 1.0 - std::cos(10.0 * (t - start)), 0.0};
  });
  while (column.time() < 0.8) {
    column.step();
    const double surface = 0.0;
    ColumnSample sample;
    column.sample({&surface, 1}, {&sample, 1});
    const double arrived = column.time() - start - travel;
    EXPECT_NEAR(sample.vx, arrived < 0.0 ? 0.0 : 2.0 * (1.0 - std::cos(10.0 * arrived)), 1e-3);
    EXPECT_EQ(sample.vy, 0.0);
  }
}

// gamma = a sin(w t) turns at w t = pi/2; a step from w t = 1.4 to 1.7 has it inside.
TEST(OdeSoil, FindsTheReversalWithinAStepAndTrialsChangeNothing) {
  const Backbone backbone{1e7, 1e-3, 1.0, 1.0};
  constexpr double amplitude = 2e-3;
  OdeSoil cell({{0, backbone}});
  const auto accept = [&](double t) {
    const std::array<double, 1> strain = {amplitude * std::sin(t)};
    const std::array<double, 1> rate = {amplitude * std::cos(t)};
    cell.accept(t, strain, rate);
  };
  accept(0.6);
  accept(1.4);
  const auto stress = [&](double t) {
    return cell.stress(0, t, amplitude * std::sin(t), amplitude * std::cos(t));
  };
  const double strain = amplitude * std::sin(1.7);
  const double exact = backbone.stress(amplitude) + 2.0 * backbone.stress(0.5 * (strain - amplitude));
  const double trial = stress(1.7);
  // The cubic misses the extremum by up to a h^4/384, and that times G0 at most goes into the stress.
  EXPECT_NEAR(trial, exact, 1e7 * amplitude * std::pow(0.3, 4) / 384.0);
  EXPECT_EQ(stress(1.7), trial);
  accept(1.7);
  EXPECT_NEAR(stress(1.7), trial, 1e-12 * std::abs(trial));
}

} // namespace
