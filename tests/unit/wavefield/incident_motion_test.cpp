#include "tests/support/layered_reference.hpp"
#include "wavefield/incident_motion.hpp"
#include "wavefield/layered_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace tremolo::wavefield;
using tremolo::testing::layered3;
using tremolo::testing::radians;

constexpr double dt = 0.01;
constexpr std::size_t count = 600;

/// Velocity of a point under a Ricker pulse that is incident at the top of the half-space, 20 m down.
std::vector<double> motion_of(const LayeredHalfSpace& profile, double surface, WaveType wave, double degrees,
                              double y) {
  const LayeredField field(profile, {wave, radians(degrees), 0.0, -20.0}, surface, ricker(3.0, 1.0, 0.1));
  const Point point{0.0, y, Side::below};
  const History h = field.sample({&point, 1}, {0.0, dt, count})[0];
  return wave == WaveType::SV ? h.vx : h.vy;
}

void expect_the_pulse(const std::vector<double>& incident, double tolerance) {
  const Signal pulse = ricker(3.0, 1.0, 0.1);
  ASSERT_EQ(incident.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_NEAR(incident[i], pulse.velocity(static_cast<double>(i) * dt), 0.1 * tolerance);
  }
}

TEST(IncidentMotion, OfAnOutcropMotion) {
  const LayeredHalfSpace profile = layered3({});
  for (const WaveType wave : {WaveType::SV, WaveType::P}) {
    for (const double degrees : {0.0, 20.0}) {
      const auto outcrop = motion_of({.half_space = profile.half_space}, -20.0, wave, degrees, -20.0);
      expect_the_pulse(incident_from_outcrop(profile, wave, radians(degrees), outcrop), 1e-10);
    }
  }
  EXPECT_DOUBLE_EQ(outcrop_factor(profile, WaveType::SV, 0.0), 2.0);
}

TEST(IncidentMotion, OfAWithinMotion) {
  const LayeredHalfSpace profile = layered3({DampingModel::kelvin_voigt, 3.0});
  for (const WaveType wave : {WaveType::SV, WaveType::P}) {
    for (const double degrees : {0.0, 20.0}) {
      const auto within = motion_of(profile, 0.0, wave, degrees, -20.0);
      const auto result = incident_from_within(profile, wave, radians(degrees), within, dt);
      expect_the_pulse(result.incident, 1e-6);
      EXPECT_GT(result.largest_amplification, 1.0); // a notch
      EXPECT_GT(result.at_hz, 0.5);
    }
  }
}

template <class Call>
void expect_refused(Call call, const std::string& words) {
  EXPECT_THAT(call, ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr(words)));
}

TEST(IncidentMotion, RefusesWhatHasNoAnswer) {
  const std::vector<double> motion(100, 0.1);
  expect_refused([&] { incident_from_outcrop(layered3({}), WaveType::SV, radians(40.0), motion); },
                 "beyond the critical angle of 30 degrees");
  expect_refused([&] { incident_from_within(layered3({}), WaveType::SV, 0.0, motion, dt); },
                 "undamped layers");
  expect_refused(
      [&] { incident_from_within(layered3({DampingModel::hysteretic}), WaveType::SV, 0.0, motion, dt, 2.0); },
      "amplification of the noise of the horizontal within motion, at ");
  const std::vector<double> broken{0.0, std::nan("")};
  expect_refused([&] { incident_from_outcrop(layered3({}), WaveType::SV, 0.0, broken); }, "is nan");
  expect_refused([&] { incident_from_outcrop(layered3({}), WaveType::SV, 0.0, {}); }, "without samples");
}

} // namespace
