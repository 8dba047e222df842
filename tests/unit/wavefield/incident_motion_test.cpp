#include "tests/support/layered_reference.hpp"
#include "wavefield/incident_motion.hpp"
#include "wavefield/layers/layered_field.hpp"
#include "wavefield/layers/transfer.hpp"
#include "wavefield/signal/fourier.hpp"

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
      ASSERT_GE(result.incident.size(), result.lead + count);
      const auto first = result.incident.begin() + static_cast<std::ptrdiff_t>(result.lead);
      expect_the_pulse({first, first + count}, 1e-6);
      EXPECT_GT(result.largest_amplification, 1.0); // a notch
      EXPECT_GT(result.at_hz, 0.5);
    }
  }
}

/// Base motion under an incident one, on a window of its own.
std::vector<double> within_motion(const LayeredHalfSpace& profile, double degrees,
                                  const std::vector<double>& incident) {
  RealFourier fourier(fast_length(3 * incident.size()));
  const auto samples = fourier.samples();
  std::fill(std::copy(incident.begin(), incident.end(), samples.begin()), samples.end(), 0.0);
  fourier.forward();
  const auto bins = fourier.bins();
  const double length = static_cast<double>(samples.size());
  bins[0] = 0.0; // the motions of this test have no mean
  for (std::size_t k = 1; k < bins.size(); ++k) {
    const double frequency = static_cast<double>(k) / (length * dt);
    bins[k] *= transfer(profile, WaveType::SV, radians(degrees), std::array{frequency},
                        std::array{profile.thickness()})[0][0]
                   .ux /
               length;
  }
  fourier.inverse();
  return {samples.begin(), samples.end()};
}

TEST(IncidentMotion, HoldsTheBaseWhereTheRecordEndsBeforeTheLayersRest) {
  const Signal pulse = ricker(3.0, 0.8, 0.1);
  std::vector<double> within(160); // the pulse has ended after 1.55 s, not so the layers
  for (std::size_t i = 0; i < within.size(); ++i) {
    within[i] = pulse.velocity(static_cast<double>(i) * dt);
  }
  for (const DampingModel model : {DampingModel::kelvin_voigt, DampingModel::hysteretic}) {
    for (const double degrees : {0.0, 20.0}) {
      const LayeredHalfSpace profile = layered3({model, 3.0});
      const auto result = incident_from_within(profile, WaveType::SV, radians(degrees), within, dt);
      const auto base = within_motion(profile, degrees, result.incident);
      double error = 0.0;
      double goes_on = 0.0;
      for (std::size_t i = 0; i < result.incident.size(); ++i) {
        const bool recorded = i >= result.lead && i - result.lead < within.size();
        error = std::max(error, std::abs(base[i] - (recorded ? within[i - result.lead] : 0.0)));
        if (i > result.lead + within.size()) {
          goes_on = std::max(goes_on, std::abs(result.incident[i]));
        }
      }
      EXPECT_LT(error, 0.1 * 1e-7) << degrees;
      EXPECT_GT(goes_on, 0.1 * 0.1);
      EXPECT_EQ(result.lead == 0, model == DampingModel::kelvin_voigt); // which alone is causal
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

/// 30 m of soft clay, which damps 20 Hz to a hundredth.
LayeredHalfSpace soft_clay() {
  return {.layers = {{.thickness = 30.0, .density = 1600.0, .vs = 100.0, .vp = 400.0, .damping = 0.12}},
          .half_space = {2100.0, 600.0, 1200.0},
          .damping = {DampingModel::hysteretic}};
}

TEST(IncidentMotion, OfARecordThatWouldBeAmplifiedTooMuchIsRefusedWithACutoffThatWillDo) {
  std::vector<double> record(1000);
  record[500] = 1.0;
  const auto with_cutoff = [&](double cutoff) {
    return incident_from_record(soft_clay(), WaveType::SV, 0.0, {record, dt, 0.0, cutoff});
  };
  std::string words;
  try {
    with_cutoff(20.0);
  } catch (const std::invalid_argument& error) {
    words = error.what();
  }
  EXPECT_THAT(words, ::testing::HasSubstr("outcrop over recorded motion, by which noise of the record is "
                                          "amplified too, at "));
  const auto place = words.find("must be at most 10: take a cutoff of ");
  ASSERT_NE(place, std::string::npos) << words;
  const double allowed = std::stod(words.substr(place + 37));
  EXPECT_LE(2.0 * with_cutoff(allowed).largest_amplification, 10.0);
  EXPECT_THROW(with_cutoff(1.5 * allowed), std::invalid_argument);
}

TEST(IncidentMotion, OfARecordRefusesWhatHasNoAnswer) {
  const std::vector<double> record(100, 0.1);
  const auto refused = [&](const LayeredHalfSpace& profile, double degrees, const RecordedMotion& given,
                           const std::string& words) {
    expect_refused([&] { incident_from_record(profile, WaveType::SV, radians(degrees), given); }, words);
  };
  const auto damped = layered3({DampingModel::hysteretic});
  refused(damped, 0.0, {record, dt, 20.5}, "depth of the record is 20.5, must be from 0 to 20 m");
  refused(damped, 0.0, {record, dt, -1.0}, "depth of the record is -1");
  refused(damped, 0.0, {record, dt, 0.0, 0.0}, "cutoff is 0, must be above 0 Hz");
  refused(damped, 0.0, {record, dt, 0.0, 0.001}, "leaves no frequency of a record of 1 s");
  refused(damped, 0.0, {record, 0.0}, "time step of the motion is 0");
  refused(damped, 40.0, {record, dt}, "beyond the critical angle of 30 degrees");
  refused(layered3({}), 0.0, {record, dt, 4.0, 15.0}, "undamped layers");
  const std::vector<double> broken{0.0, std::nan("")};
  refused(damped, 0.0, {broken, dt}, "is nan");
  refused(damped, 0.0, {{}, dt}, "without samples");
}

} // namespace
