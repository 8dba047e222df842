#include "motion/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace tremolo::motion {
namespace {

template <class Call>
std::string error_of(Call&& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Units, InEverySpelling) {
  for (const char* text :
       {"cm/s2", "CM/S/S", "cm/sec2", "CM/SEC/SEC", "cm/s**2", "cm/s^2", "gal", "cm/s\u00b2"})
    EXPECT_EQ(unit_named(text), Unit::cm_s2) << text;
  EXPECT_EQ(unit_named("G"), Unit::g);
  EXPECT_EQ(unit_named("m/sec"), Unit::m_s);
  EXPECT_FALSE(unit_named("furlong"));
  EXPECT_FALSE(unit_named(""));
}

TEST(Units, ConvertWithinTheirQuantityOnly) {
  const Record record{.unit = Unit::g, .dt = 0.1, .samples = {0.0, 1.0, -2.0}};
  EXPECT_DOUBLE_EQ(converted(record, Unit::m_s2).samples[1], 9.80665);
  EXPECT_DOUBLE_EQ(converted(record, Unit::cm_s2).samples[2], -1961.33);
  EXPECT_EQ(converted(record, Unit::cm_s2).unit, Unit::cm_s2);
  EXPECT_EQ(error_of([&] { converted(record, Unit::cm_s); }),
            "cm/s is a unit of velocity, the motion is acceleration in g");
}

TEST(Units, BecomeThoseOfAnotherQuantityByIntegrationAndSlope) {
  // d = sin^4(pi t / T) is at rest at both ends.
  const double dt = 0.005;
  const double period = 4.0;
  Record displacement{.unit = Unit::mm, .kind = MotionKind::outcrop, .dt = dt};
  std::vector<double> velocity;
  for (int i = 0; i <= 800; ++i) {
    const double phase = std::numbers::pi * i * dt / period;
    displacement.samples.push_back(1e3 * std::pow(std::sin(phase), 4));
    velocity.push_back(4.0 * std::numbers::pi / period * std::pow(std::sin(phase), 3) * std::cos(phase));
  }
  const Record slope = with_unit(displacement, Unit::m_s);
  ASSERT_EQ(slope.quantity(), Quantity::velocity);
  EXPECT_EQ(slope.kind, MotionKind::outcrop);
  for (std::size_t i = 0; i < velocity.size(); ++i)
    ASSERT_NEAR(slope.samples[i], velocity[i], 1e-7) << i;
  const Record again = with_unit(with_unit(displacement, Unit::g), Unit::mm);
  for (std::size_t i = 0; i < velocity.size(); ++i) // trapezoidal: dt^2/12 of the second derivative, twice
    ASSERT_NEAR(again.samples[i], displacement.samples[i], 0.02) << i;
}

TEST(Calculus, StraightLines) {
  EXPECT_EQ(differentiate(std::vector{1.0, 3.0}, 0.5), (std::vector{4.0, 4.0}));
  for (const double slope : differentiate(std::vector{0.0, 1.0, 2.0, 3.0}, 0.25))
    EXPECT_NEAR(slope, 4.0, 1e-14);
  EXPECT_EQ(integrate(std::vector{1.0, 3.0, 5.0}, 0.5), (std::vector{0.0, 1.0, 3.0}));
  EXPECT_THROW(differentiate(std::vector{1.0}, 0.5), std::invalid_argument);
}

TEST(Kinds, OutcropIsTwiceTheIncidentMotion) {
  const Record incident{.kind = MotionKind::incident, .dt = 0.1, .samples = {1.0, 3.0}};
  const Record outcrop = as_kind(incident, MotionKind::outcrop);
  EXPECT_EQ(outcrop.samples, (std::vector{2.0, 6.0}));
  EXPECT_EQ(outcrop.kind, MotionKind::outcrop);
  EXPECT_EQ(as_kind(outcrop, MotionKind::incident).samples, incident.samples);
  EXPECT_EQ(as_kind(outcrop, MotionKind::outcrop).samples, outcrop.samples);
}

TEST(Kinds, WithinNeedsTheProfileAndTheUnsaidAWord) {
  Record record{.kind = MotionKind::within, .dt = 0.1, .samples = {1.0, 3.0}};
  EXPECT_EQ(as_kind(record, MotionKind::within).samples, record.samples);
  EXPECT_EQ(
      error_of([&] { as_kind(record, MotionKind::outcrop); }),
      "from within to outcrop the layers above the place are needed: multiply by the transfer function of "
      "the profile (tremolo wave --transfer, or a column with that base motion)");
  record.kind = MotionKind::incident;
  EXPECT_NE(error_of([&] { as_kind(record, MotionKind::within); }), "");
  record.kind.reset();
  EXPECT_EQ(error_of([&] { as_kind(record, MotionKind::incident); }),
            "the motion does not say whether it is incident, outcrop or within: say which before it is made "
            "incident");
}

TEST(Soundness, RefusesWhatIsNoMotion) {
  Record record{.dt = 0.1, .samples = {1.0, 2.0}};
  EXPECT_NO_THROW(require_sound(record));
  record.samples[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(require_sound(record), std::invalid_argument);
  record.samples = {1.0};
  EXPECT_EQ(error_of([&] { require_sound(record); }),
            "a motion needs at least 2 samples, all finite, and dt > 0, has 1 and dt = 0.1 s");
}

} // namespace
} // namespace tremolo::motion
