#include "base/samples.hpp"
#include "motion/fourier.hpp"
#include "motion/make/pulses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::motion {
namespace {

TEST(Pulses, RickerPeaksAndCrossesZeroWhereItShould) {
  const Pulse pulse{.amplitude = 2.0, .time = 1.0, .frequency = 4.0};
  EXPECT_DOUBLE_EQ(value(pulse, 1.0), 2.0);
  const double crossing = 1.0 / (std::numbers::sqrt2 * std::numbers::pi * 4.0);
  EXPECT_NEAR(value(pulse, 1.0 + crossing), 0.0, 1e-14);
  // The trough at a = 3/2: -2 exp(-3/2).
  EXPECT_NEAR(value(pulse, 1.0 - std::sqrt(1.5) / (std::numbers::pi * 4.0)), -4.0 * std::exp(-1.5), 1e-14);
}

TEST(Pulses, OrmsbyHasATrapezoidForItsSpectrum) {
  // Normalised to its peak: the area under the two-sided trapezoid is 1, so its height is 1/(f4 + f3 - f2 -
  // f1).
  const Pulse pulse{
      .shape = PulseShape::ormsby, .amplitude = 1.0, .time = 50.0, .corners = {1.0, 2.0, 6.0, 9.0}};
  EXPECT_NEAR(value(pulse, 50.0), 1.0, 1e-14);
  const double dt = 0.01;
  const auto bins = transform(sampled(pulse, Unit::m_s, dt, 10001).samples);
  const double height = 1.0 / (9.0 + 6.0 - 2.0 - 1.0);
  for (const auto& [f, part] : {std::pair{0.5, 0.0}, {1.5, 0.5}, {4.0, 1.0}, {7.5, 0.5}, {12.0, 0.0}}) {
    const auto j = static_cast<std::size_t>(std::lround(f * dt * 10001.0));
    EXPECT_NEAR(dt * std::abs(bins[j]), part * height, 2e-4 * height + 2e-4) << f;
  }
}

TEST(Pulses, SinesHaveTheirCyclesAndRamps) {
  Pulse pulse{.shape = PulseShape::harmonic, .amplitude = 3.0, .time = 1.0, .frequency = 2.0, .cycles = 10.0};
  EXPECT_EQ(value(pulse, 0.99), 0.0);
  EXPECT_EQ(value(pulse, 6.01), 0.0);
  EXPECT_NEAR(value(pulse, 1.125), 3.0, 1e-14); // a quarter of a cycle
  pulse.shape = PulseShape::tapered_sine;
  pulse.ramp_cycles = 2.5;
  EXPECT_NEAR(value(pulse, 1.0 + 1.25 / 2.0), 1.5, 1e-12); // half way up the cosine, at a crest
  EXPECT_NEAR(value(pulse, 1.0 + 5.25 / 2.0), 3.0, 1e-12);
  pulse.shape = PulseShape::centrifuge;
  EXPECT_NEAR(value(pulse, 1.0 + 0.25 / 2.0), 0.3, 1e-12); // a tenth of the straight ramp
  EXPECT_NEAR(value(pulse, 1.0 + 5.25 / 2.0), 3.0, 1e-12);
  pulse.third_harmonic = 0.2;
  EXPECT_NEAR(value(pulse, 1.0 + 5.25 / 2.0), 3.0 * (1.0 - 0.2), 1e-12);
}

TEST(Pulses, OfACentrifugeEndAtRest) {
  const Pulse pulse{.shape = PulseShape::centrifuge,
                    .time = 0.5,
                    .frequency = 1.0,
                    .cycles = 16.0,
                    .ramp_cycles = 4.0,
                    .third_harmonic = 0.1};
  const auto velocity = integrate(sampled(pulse, Unit::m_s2, 0.01, 1800).samples, 0.01);
  EXPECT_LT(std::abs(velocity.back()), 0.01 * peak(velocity));
}

TEST(Pulses, AreRefusedOutOfRange) {
  const auto refused = [](Pulse pulse) { EXPECT_THROW(require_sound(pulse), std::invalid_argument); };
  refused({.frequency = 0.0});
  refused({.frequency = NAN});
  refused({.amplitude = INFINITY});
  refused({.shape = PulseShape::ormsby, .corners = {1.0, 2.0, 2.0, 3.0}});
  refused({.shape = PulseShape::harmonic, .cycles = 0.0});
  refused({.shape = PulseShape::tapered_sine, .cycles = 4.0, .ramp_cycles = 2.5});
  refused({.shape = PulseShape::centrifuge, .cycles = 4.0, .third_harmonic = -0.1});
  EXPECT_THROW(sampled({}, Unit::m_s, 0.0, 100), std::invalid_argument);
  EXPECT_THROW(sampled({}, Unit::m_s, 0.1, 1), std::invalid_argument);
}

} // namespace
} // namespace tremolo::motion
