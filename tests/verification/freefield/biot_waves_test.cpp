// Speed and decay of both compression waves in the two-phase column against their dispersion relation, and
// the column on which weight is put at once.

#include "tests/support/biot_waves.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace tremolo::freefield::testing {
namespace {

constexpr double modulus = 1e8; // M, Pa
using Complex = std::complex<double>;

/// Amplitudes of e^{iwt} in the pore pressure at levels, over two periods.
std::vector<Complex> pressures(TwoPhaseColumn& column, const std::vector<double>& levels, double frequency) {
  const double begin = column.time();
  const double w = 2.0 * std::numbers::pi * frequency;
  const auto steps = static_cast<long>(std::lround(2.0 / frequency / column.time_step()));
  std::vector<ColumnSample> samples(levels.size());
  std::vector<Complex> found(levels.size());
  for (long i = 0; i < steps; ++i) {
    column.step();
    column.sample(levels, samples);
    const auto phase = std::polar(2.0 / static_cast<double>(steps), -w * (column.time() - begin));
    for (std::size_t k = 0; k < levels.size(); ++k)
      found[k] += phase * samples[k].pore_pressure;
  }
  return found;
}

/// Grows over `periods` to a sine.
double growing_sine(double time, double frequency, double periods) {
  const double s = std::clamp(time * frequency / periods, 0.0, 1.0);
  return s * s * s * (10.0 - 15.0 * s + 6.0 * s * s) * std::sin(2.0 * std::numbers::pi * frequency * time);
}

class Dispersion : public ::testing::TestWithParam<std::tuple<double, double>> {};

/// In the column both waves run up and down, p = sum A_m cos(k_m y) + B_m sin(k_m y), so that with equal
/// distances d between levels (T - 2 cos k_1 d)(T - 2 cos k_2 d) p = 0, T p_j = p_{j+1} + p_{j-1}: two
/// numbers that a least-squares fit to the levels finds, without theory.
TEST_P(Dispersion, SlowWaveHasItsSpeedAndDecay) {
  const auto [frequency, permeability] = GetParam();
  const BiotWave exact = biot_waves(modulus, permeability, frequency)[1];
  const double decay = exact.decay_length();
  const double height = 4.0 * decay;
  const Profile profile = wet_profile({wet_layer(height, modulus, permeability)});
  auto settings = wet_settings(profile, decay / 20.0);
  settings.surface_load = [f = frequency](double time) { return 1e4 * growing_sine(time, f, 6.0); };
  TwoPhaseColumn column(profile, settings, at_rest);
  march(column, 18.0 / frequency);
  const double distance = 0.4 * decay;
  std::vector<double> levels;
  for (int j = 0; j < 9; ++j)
    levels.push_back(-height + 0.4 * decay + distance * j);
  const auto p = pressures(column, levels, frequency);
  Eigen::Matrix<Complex, 5, 2> left;
  Eigen::Matrix<Complex, 5, 1> right;
  for (int j = 2; j < 7; ++j) {
    left.row(j - 2) << p[j + 1] + p[j - 1], -p[j];
    right(j - 2) = p[j + 2] + 2.0 * p[j] + p[j - 2];
  }
  // Sum and product of both 2 cos k d; the slow wave's is farther from 2.
  const Eigen::Vector2cd fit = left.colPivHouseholderQr().solve(right);
  const Complex root = std::sqrt(0.25 * fit(0) * fit(0) - fit(1));
  const Complex one = 0.5 * fit(0) + root, other = 0.5 * fit(0) - root;
  const Complex cosine = std::abs(one - 2.0) > std::abs(other - 2.0) ? one : other;
  const Complex number = std::acos(0.5 * cosine) / distance;
  const BiotWave found{number.real() < 0.0 ? -number : number, {}, frequency};
  EXPECT_NEAR(found.speed(), exact.speed(), 0.02 * exact.speed());
  EXPECT_NEAR(found.decay_length(), decay, 0.05 * decay);
}

/// A wave from a base that shakes, before anything comes back: p at one level over p at another is e^{-ikd}.
TEST_P(Dispersion, FastWaveHasItsSpeedAndDecay) {
  const auto [frequency, permeability] = GetParam();
  const BiotWave exact = biot_waves(modulus, permeability, frequency)[0];
  const double length = exact.speed() / frequency;
  const double height = 8.0 * length;
  const Profile profile = wet_profile({wet_layer(height, modulus, permeability)});
  const auto settings = wet_settings(profile, length / 80.0);
  TwoPhaseColumn column(profile, settings, [f = frequency](double time) {
    return Velocity{0.0, 0.01 * growing_sine(time, f, 3.0)};
  });
  march(column, 6.5 / frequency);
  const auto p = pressures(column, {-height + 1.0 * length, -height + 2.0 * length}, frequency);
  const double phase = -std::arg(p[1] / p[0]) + 2.0 * std::numbers::pi; // one wavelength
  const Complex number((phase > 3.0 * std::numbers::pi ? phase - 2.0 * std::numbers::pi : phase) / length,
                       std::log(std::abs(p[1] / p[0])) / length);
  const BiotWave found{number, {}, frequency};
  EXPECT_NEAR(found.speed(), exact.speed(), 0.02 * exact.speed());
  EXPECT_NEAR(found.decay_length(), exact.decay_length(), 0.05 * exact.decay_length());
}

INSTANTIATE_TEST_SUITE_P(TwoPhase, Dispersion,
                         ::testing::Values(std::tuple(10.0, 1e-2), std::tuple(100.0, 1e-2),
                                           std::tuple(10.0, 1e-3)),
                         [](const auto& one) { return "Case" + std::to_string(one.index + 1); });

/// The relation itself, against values that were computed apart.
TEST(TwoPhaseColumnVerification, DispersionRelationHasItsKnownValues) {
  const auto at = [](double permeability, double frequency) {
    return biot_waves(modulus, permeability, frequency);
  };
  EXPECT_NEAR(at(1e-2, 10.0)[0].speed(), 1681.0, 1.0);
  EXPECT_NEAR(at(1e-2, 10.0)[1].speed(), 103.7, 0.1);
  EXPECT_NEAR(at(1e-2, 10.0)[1].decay_length(), 1.93, 0.01);
  EXPECT_NEAR(at(1e-2, 100.0)[0].speed(), 1800.0, 1.0);
  EXPECT_NEAR(at(1e-2, 100.0)[0].decay_length(), 58.0, 0.1);
  EXPECT_NEAR(at(1e-2, 100.0)[1].speed(), 191.0, 1.0);
  EXPECT_NEAR(at(1e-2, 100.0)[1].decay_length(), 1.05, 0.01);
  EXPECT_NEAR(at(1e-3, 10.0)[1].speed(), 35.2, 0.1);
  EXPECT_NEAR(at(1e-3, 10.0)[1].decay_length(), 0.569, 0.001);
}

/// A base that begins to accelerate upwards at once is weight that is put on at once: the pressure swings
/// about its share of that weight with c_u/4H.
TEST(TwoPhaseColumnVerification, WeightPutOnAtOnceSwingsWithTheUndrainedPeriod) {
  constexpr double height = 10.0, acceleration = 0.5;
  const Profile profile = wet_profile({wet_layer(height, modulus, 1e-9)});
  TwoPhaseColumn column(profile, wet_settings(profile, 0.1), [](double time) {
    return Velocity{0.0, acceleration * std::max(time, 0.0)};
  });
  const auto pores = *profile.layers[0].pores;
  const double stiffness = materials::pore_stiffness(pores, water);
  const double frequency = materials::saturated_speeds(modulus, pores, water).undrained / (4.0 * height);
  const double at_rest_later =
      profile.layers[0].soil.density * acceleration * height * stiffness / (modulus + stiffness);
  std::vector<double> rises; // times at which pressure passes its mean, upwards
  double before = 0.0, sum = 0.0;
  long count = 0;
  while (rises.size() < 21) {
    column.step();
    const double now = sample_at(column, -height).pore_pressure;
    if (before < at_rest_later && now >= at_rest_later)
      rises.push_back(column.time() - column.time_step() * (now - at_rest_later) / (now - before));
    if (!rises.empty()) {
      sum += now;
      ++count;
    }
    before = now;
  }
  const double measured = 20.0 / (rises.back() - rises.front());
  EXPECT_NEAR(measured, frequency, 0.01 * frequency);
  EXPECT_NEAR(sum / static_cast<double>(count), at_rest_later, 0.01 * at_rest_later);
}

} // namespace
} // namespace tremolo::freefield::testing
