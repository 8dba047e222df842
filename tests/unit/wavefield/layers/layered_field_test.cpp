#include "tests/support/layered_reference.hpp"
#include "wavefield/layers/layered_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace tremolo::wavefield;
using tremolo::testing::layered3;
using tremolo::testing::radians;

double largest(const std::vector<double>& values) {
  double result = 0.0;
  for (const double value : values) {
    result = std::max(result, std::abs(value));
  }
  return result;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double result = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result = std::max(result, std::abs(a[i] - b[i]));
  }
  return result;
}

LayeredField field(const LayeredHalfSpace& profile, WaveType wave, double degrees,
                   const SynthesisOptions& options = {}) {
  return {profile, {wave, radians(degrees), 2.0, -25.0}, 0.0, ricker(3.0, 0.8, 0.1), options};
}

struct Wave {
  WaveType wave;
  double degrees;
  Damping damping;
};

class InLayers : public ::testing::TestWithParam<Wave> {
protected:
  LayeredField under_test() const {
    return field(layered3(GetParam().damping), GetParam().wave, GetParam().degrees);
  }
};

// rho dv/dt = div sigma for any damping, strains are the gradient of displacement, and without damping
// Hooke's law holds: by eighth-order differences in space, in both layers and the half-space.
TEST_P(InLayers, MomentumStrainAndHooke) {
  constexpr std::array weights{4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  const double h = 0.25;
  const auto profile = layered3(GetParam().damping);
  struct Place {
    double y, density, vs, vp;
  };
  for (const Place place : {Place{-3.0, 1700.0, 120.0, 300.0}, Place{-13.0, 1850.0, 220.0, 500.0},
                            Place{-27.0, 2100.0, 500.0, 1000.0}}) {
    std::vector<Point> points = {{9.0, place.y}};
    for (int k = 1; k <= 4; ++k) {
      points.insert(
          points.end(),
          {{9.0 + h * k, place.y}, {9.0 - h * k, place.y}, {9.0, place.y + h * k}, {9.0, place.y - h * k}});
    }
    const auto at = under_test().sample(points, {0.7, 0.02, 40});
    const auto slope = [&](std::vector<double> History::*q, std::size_t first, std::size_t i) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        sum += weights[k] * ((at[4 * k + first].*q)[i] - (at[4 * k + first + 1].*q)[i]);
      }
      return sum / h;
    };
    const auto ddx = [&](std::vector<double> History::*q, std::size_t i) { return slope(q, 1, i); };
    const auto ddy = [&](std::vector<double> History::*q, std::size_t i) { return slope(q, 3, i); };
    const History& here = at[0];
    const double acceleration = std::max(largest(here.vx_rate), largest(here.vy_rate));
    const double strain = std::max({largest(here.exx), largest(here.eyy), largest(here.gxy)});
    const double stress = std::max({largest(here.sxx), largest(here.syy), largest(here.sxy)});
    const double mu = place.density * place.vs * place.vs;
    const double lambda = place.density * place.vp * place.vp - 2.0 * mu;
    for (std::size_t i = 0; i < here.vx.size(); ++i) {
      EXPECT_NEAR(here.vx_rate[i], (ddx(&History::sxx, i) + ddy(&History::sxy, i)) / place.density,
                  1e-6 * acceleration);
      EXPECT_NEAR(here.vy_rate[i], (ddx(&History::sxy, i) + ddy(&History::syy, i)) / place.density,
                  1e-6 * acceleration);
      EXPECT_NEAR(here.exx[i], ddx(&History::ux, i), 1e-6 * strain);
      EXPECT_NEAR(here.eyy[i], ddy(&History::uy, i), 1e-6 * strain);
      EXPECT_NEAR(here.gxy[i], ddy(&History::ux, i) + ddx(&History::uy, i), 1e-6 * strain);
      if (GetParam().damping.model == DampingModel::none) {
        EXPECT_NEAR(here.sxx[i], (lambda + 2.0 * mu) * here.exx[i] + lambda * here.eyy[i], 1e-9 * stress);
        EXPECT_NEAR(here.syy[i], (lambda + 2.0 * mu) * here.eyy[i] + lambda * here.exx[i], 1e-9 * stress);
        EXPECT_NEAR(here.sxy[i], mu * here.gxy[i], 1e-9 * stress);
      }
    }
  }
}

TEST_P(InLayers, TractionVanishesAtTheSurfaceAndPassesInterfaces) {
  const std::array<Point, 5> points{{{4.0, 0.0},
                                     {4.0, -6.0, Side::above},
                                     {4.0, -6.0, Side::below},
                                     {4.0, -20.0, Side::above},
                                     {4.0, -20.0, Side::below}}};
  const auto at = under_test().sample(points, {0.5, 0.01, 150});
  const double stress = 0.1 * 2100.0 * 1000.0;
  EXPECT_LT(largest(at[0].sxy), 1e-12 * stress);
  EXPECT_LT(largest(at[0].syy), 1e-12 * stress);
  for (const std::size_t above : {1U, 3U}) {
    const History& a = at[above];
    const History& b = at[above + 1];
    EXPECT_LT(largest_difference(a.vx, b.vx), 1e-11);
    EXPECT_LT(largest_difference(a.vy, b.vy), 1e-11);
    EXPECT_LT(largest_difference(a.sxy, b.sxy), 1e-11 * stress);
    EXPECT_LT(largest_difference(a.syy, b.syy), 1e-11 * stress);
    EXPECT_GT(largest_difference(a.gxy, b.gxy), 1e-7);
    if (GetParam().degrees > 0.0) {
      EXPECT_GT(largest_difference(a.sxx, b.sxx), 1e-4 * stress); // sxx jumps
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Waves, InLayers,
                         ::testing::Values(Wave{WaveType::SV, 0.0, {DampingModel::hysteretic}},
                                           Wave{WaveType::SV, 20.0, {DampingModel::none}},
                                           Wave{WaveType::SV, 40.0, {DampingModel::none}},
                                           Wave{WaveType::SV, 40.0, {DampingModel::shake}},
                                           Wave{WaveType::P, 50.0, {DampingModel::kelvin_voigt, 3.0}},
                                           Wave{WaveType::SV, 25.0, {DampingModel::kjartansson, 3.0}},
                                           Wave{WaveType::P, 25.0, {DampingModel::constant, 3.0}}));

TEST(LayeredField, IsTheHalfSpaceWithIdenticalLayers) {
  const HalfSpace soil{1700.0, 96.0, 174.0};
  const Layer slice{.thickness = 7.0, .density = 1700.0, .vs = 96.0, .vp = 174.0};
  const std::array<Point, 3> points{{{0.0, 0.0}, {11.0, -9.0}, {3.0, -30.0}}};
  const TimeGrid grid{0.2, 0.02, 100};
  for (const double degrees : {0.0, 20.0, 40.0}) {
    const auto whole = field({.half_space = soil}, WaveType::SV, degrees).sample(points, grid);
    const auto sliced =
        field({.layers = {slice, slice}, .half_space = soil}, WaveType::SV, degrees).sample(points, grid);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LT(largest_difference(whole[i].vx, sliced[i].vx), 1e-10);
      EXPECT_LT(largest_difference(whole[i].vy, sliced[i].vy), 1e-10);
      EXPECT_LT(largest_difference(whole[i].sxx, sliced[i].sxx), 1e-10 * 1700.0 * 174.0);
    }
  }
}

TEST(LayeredField, SidesOfDifferentHeightSeeOneIncidentWave) {
  // The same half-space under 20 m and under 6 m of soil: in the rock both have the same incident wave.
  LayeredHalfSpace thin = layered3({});
  thin.layers.pop_back();
  const Incidence incidence{WaveType::SV, radians(20.0), 2.0, -30.0};
  const LayeredField left(layered3({}), incidence, 0.0, ricker(3.0, 0.8, 0.1));
  const LayeredField right(thin, incidence, -12.0, ricker(3.0, 0.8, 0.1));
  const Point rock{40.0, -33.0};
  const TimeGrid grid{0.5, 0.01, 150};
  const History a = left.sample({&rock, 1}, grid, Part::incident)[0];
  const History b = right.sample({&rock, 1}, grid, Part::incident)[0];
  EXPECT_GT(largest(a.vx), 0.09);
  EXPECT_LT(largest_difference(a.vx, b.vx), 1e-12);
  EXPECT_LT(largest_difference(a.sxy, b.sxy), 1e-12 * 2100.0 * 500.0);
}

// A base at the top of the half-space takes the incident wave there, whichever side of the interface it
// names.
TEST(LayeredField, TopOfTheHalfSpaceHasAnIncidentWave) {
  const TimeGrid grid{0.5, 0.01, 150};
  const std::array<Point, 3> points{
      {{0.0, -20.0, Side::above}, {0.0, -20.0, Side::below}, {0.0, -20.001, Side::above}}};
  const auto histories = field(layered3({}), WaveType::SV, 0.0).sample(points, grid, Part::incident);
  EXPECT_GT(largest(histories[0].vx), 0.09);
  EXPECT_EQ(histories[0].vx, histories[1].vx);
  EXPECT_LT(largest_difference(histories[0].vx, histories[2].vx), 1e-4);
}

/// Before the pulse of 0.8 s arrives the surface moves by rounding alone, which no window makes smaller.
TEST(LayeredField, IsServedBeforeItsPulseArrives) {
  for (const WaveType wave : {WaveType::SV, WaveType::P}) {
    const auto under_test = field(layered3({}), wave, 15.0);
    const std::array<Point, 2> points{{{2.0, 0.0}, {2.0, -25.0}}};
    const auto early = under_test.sample(points, {0.0, 0.01, 10});
    const auto whole = under_test.sample(points, {0.0, 0.01, 200});
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LT(largest(early[i].vx), 0.01 * largest(whole[i].vx));
      for (std::size_t k = 0; k < early[i].vx.size(); ++k) {
        EXPECT_NEAR(early[i].vx[k], whole[i].vx[k], 1e-9 * 0.1);
        EXPECT_NEAR(early[i].vy[k], whole[i].vy[k], 1e-9 * 0.1);
      }
    }
  }
}

TEST(LayeredField, GivesOnlyWhatIsAskedFor) {
  const Point point{0.0, -3.0};
  const TimeGrid grid{0.0, 0.01, 100};
  const LayeredField sv = field(layered3({}), WaveType::SV, 20.0);
  const History all = sv.sample({&point, 1}, grid)[0];
  const History strain = sv.sample(
      {&point, 1}, grid, Part::total,
      {.displacement = false, .velocity = false, .stress = false, .strain = true, .rates = true})[0];
  EXPECT_EQ(strain.exx, all.exx);
  EXPECT_EQ(strain.gxy, all.gxy);
  EXPECT_TRUE(strain.ux.empty() && strain.vx.empty() && strain.vy.empty() && strain.sxx.empty());
  EXPECT_TRUE(strain.vx_rate.empty() && strain.sxx_rate.empty());
}

TEST(LayeredField, KeepsTheOffsetThatASignalLeavesUnderConstantDamping) {
  // Vertical incidence: the surface ends at twice the displacement of the incident wave.
  const double k = 20.0;
  const Signal bump{[=](double t) { return std::exp(-k * k * (t - 1.0) * (t - 1.0)); }, 0.6, 1.4, 30.0};
  const LayeredField vertical(layered3({DampingModel::hysteretic}), {WaveType::SV, 0.0, 0.0, -20.0}, 0.0,
                              bump);
  const Point surface{0.0, 0.0};
  const History h = vertical.sample({&surface, 1}, {0.0, 0.01, 600})[0];
  const double offset = std::sqrt(std::numbers::pi) / k;
  EXPECT_NEAR(h.ux.front(), 0.0, 2e-2 * offset); // constant damping is not causal: tails like 1/t
  EXPECT_NEAR(h.ux.back(), 2.0 * offset, 2e-2 * offset);
  for (std::size_t i = 4; i + 4 < h.ux.size(); ++i) {
    const double slope =
        (4.0 / 5.0 * (h.ux[i + 1] - h.ux[i - 1]) - 1.0 / 5.0 * (h.ux[i + 2] - h.ux[i - 2]) +
         4.0 / 105.0 * (h.ux[i + 3] - h.ux[i - 3]) - 1.0 / 280.0 * (h.ux[i + 4] - h.ux[i - 4])) /
        0.01;
    EXPECT_NEAR(slope, h.vx[i], 1e-3);
  }
}

template <class Call>
void expect_refused(Call call, const std::string& words) {
  EXPECT_THAT(call, ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr(words)));
}

TEST(LayeredField, RefusesProfilesAndPlacesThatMakeNoSense) {
  const auto refused = [](auto change, const std::string& words) {
    LayeredHalfSpace profile = layered3({DampingModel::hysteretic});
    change(profile);
    expect_refused([&] { field(profile, WaveType::SV, 10.0); }, words);
  };
  refused([](LayeredHalfSpace& p) { p.layers[1].thickness = 0.0; }, "layer 2 from the top: thickness is 0");
  refused([](LayeredHalfSpace& p) { p.layers[0].vp = 130.0; },
          "layer 1 from the top: vp is 130, must be above");
  refused([](LayeredHalfSpace& p) { p.layers[0].damping = 0.7; },
          "damping ratio is 0.7, must be in [0, 0.5)");
  refused([](LayeredHalfSpace& p) { p.damping.model = DampingModel::none; }, "name a damping model");
  refused([](LayeredHalfSpace& p) { p.damping.model = DampingModel::kelvin_voigt; },
          "reference frequency of kelvin_voigt damping is 0");
  refused([](LayeredHalfSpace& p) { p.half_space.density = std::nan(""); }, "half-space density is nan");

  const Point in_layer{0.0, -12.0};
  const TimeGrid grid{0.0, 0.01, 10};
  expect_refused(
      [&] {
        field(layered3({}), WaveType::SV, 10.0).sample({&in_layer, 1}, grid, Part::incident);
      },
      "y of a point for the incident wave alone is -12, must be in the half-space, whose top is at y = -20 "
      "m");
  expect_refused(
      [] {
        LayeredField(layered3({DampingModel::hysteretic}), {WaveType::SV, 0.1, 0.0, -10.0}, 0.0,
                     ricker(3.0, 1.0, 0.1));
      },
      "y of the reference point is -10, must be in the damped half-space");
}

} // namespace
