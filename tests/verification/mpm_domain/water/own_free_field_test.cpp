// Saturated flat ground between free fields of its own discretisation: it moves as they do, everywhere. A
// wave of compression makes the water flow, so that grains and water have velocities of their own.

#include "tests/support/box_run.hpp"
#include "tests/support/own_column.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace tremolo::mpm_domain {
namespace {

constexpr double depth = 10.0; // m
constexpr double h = 0.5;      // m
constexpr double peak = 1e-4;  // m/s
const materials::Elasticity rock = {2200.0, 3e9, 0.25};

Spec wet_box(double permeability) {
  Spec spec = test_support::elastic_box(4.0, depth, h);
  spec.gravity = 9.81;
  spec.water = {0.0, {}};
  Soil& soil = spec.soils.front();
  soil.pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = permeability};
  soil.law = materials::LinearElastic{{materials::saturated_density(*soil.pores, {}), 40e6, 0.28}};
  const double m = materials::elasticity(soil.law).p_modulus();
  spec.scheme.dt = 0.5 * 0.65 * h / materials::saturated_speeds(m, *soil.pores, {}).fast;
  return spec;
}

/// A Ricker pulse of 5 Hz, m/s.
double pulse(double t) {
  const double a = std::pow(std::numbers::pi * 5.0 * (t - 0.3), 2);
  return peak * (1.0 - 2.0 * a) * std::exp(-a);
}

/// Waves that come up vertically.
eq6::FreeField compression(double t) {
  const double v = pulse(t);
  const double syy = -rock.density * rock.p_wave_speed() * v;
  return {{0.0, v}, {rock.lame() / rock.p_modulus() * syy, syy, 0.0}};
}
eq6::FreeField shear(double t) {
  const double v = pulse(t);
  return {{v, 0.0}, {0.0, 0.0, -rock.density * rock.s_wave_speed() * v}};
}

/// Largest differences at one level, over the largest value: of velocities along the motion of the wave, and
/// of settlements.
struct Unevenness {
  double velocity, settlement;
};

Unevenness beside_own_column(double permeability, eq6::FreeField (*incident)(double)) {
  test_support::FlatGround ground(wet_box(permeability), rock, incident);
  Domain& domain = ground.domain;
  Stepper& stepper = *ground.stepper;
  struct Range {
    double low = 1e9, high = -1e9;
    void add(double v) { low = std::min(low, v), high = std::max(high, v); }
  };
  double fastest = 0.0, farthest = 0.0;
  Unevenness largest{};
  while (stepper.time() < 1.0) {
    stepper.step();
    std::map<long, Range> velocities, settlements;
    for (const Particles& set : domain.sets) {
      const std::vector<double>& v = incident == shear ? set.vx : set.vy;
      for (std::size_t k = 0; k < set.size(); ++k) {
        const long row = std::lround(1e3 * set.y_initial[k]);
        const double moved = set.y[k] - set.y_initial[k];
        velocities[row].add(v[k]);
        settlements[row].add(moved);
        fastest = std::max(fastest, std::abs(v[k]));
        farthest = std::max(farthest, std::abs(moved));
      }
    }
    for (const auto& [row, range] : velocities)
      largest.velocity = std::max(largest.velocity, range.high - range.low);
    for (const auto& [row, range] : settlements)
      largest.settlement = std::max(largest.settlement, range.high - range.low);
  }
  EXPECT_GT(fastest, peak);
  return {largest.velocity / fastest, largest.settlement / farthest};
}

/// The sides feel the dashpots' mean of grains and water, and a free field serves this mean. One that served
/// the grains alone would hold the sides back by the momentum of the water.
class SaturatedOwnFreeField : public testing::TestWithParam<double> {};

TEST_P(SaturatedOwnFreeField, IsWhatAFlatDomainDoesEverywhere) {
  const Unevenness measured = beside_own_column(GetParam(), compression);
  EXPECT_LT(measured.velocity, 1e-5);
  EXPECT_LT(measured.settlement, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Permeabilities, SaturatedOwnFreeField, testing::Values(1e-2));
INSTANTIATE_TEST_SUITE_P(AcceptancePermeabilities, SaturatedOwnFreeField, testing::Values(1e-1, 1e-4));

/// Sides lean by the strain of the shear, so that the weight of the soil acts on them as a couple.
TEST(SidesOfSaturatedGround, LeanAsItDoes) {
  const double measured = beside_own_column(1e-4, shear).velocity;
  RecordProperty("unevenness", std::to_string(1e6 * measured) + "e-6");
  EXPECT_LT(measured, 1e-6);
}

} // namespace
} // namespace tremolo::mpm_domain
