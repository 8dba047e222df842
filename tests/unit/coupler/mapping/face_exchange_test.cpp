#include "coupler/mapping/face_exchange.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tremolo::coupler {
namespace {

using testing::HasSubstr;

/// A left side at rest in a free field that moves as v = (t, 2 t) with constant stress; slope of values
/// exact.
FieldDescription ramp() {
  return {.name = "total",
          .y = {-10.0, 0.0},
          .start_time = 0.0,
          .time_step = 0.5,
          .step_count = 9,
          .steps_per_frame = 64};
}

ExchangedFace left_face(double y) {
  return {.position = {0.0, y},
          .dashpot = {{-1.0, 0.0}, 6.0, 3.0},
          .static_traction = {100.0, 7.0},
          .source = "left",
          .field = "total"};
}

std::vector<double> ramp_step(double t) {
  std::vector<double> values;
  for (int point = 0; point < 2; ++point)
    values.insert(values.end(), {t, 2.0 * t, 10.0, 20.0, 30.0, 1.0, 2.0, 0.0, 0.0, 0.0});
  return values;
}

std::string refusal(const ExchangedFace& face, double start_time, double end_time) {
  try {
    FaceExchange({{"left", 1, {ramp()}}}, {face}, start_time, end_time);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(FaceExchange, AppliesEquation6ToTheMappedFreeField) {
  FaceExchange exchange({{"left", 1, {ramp()}}}, {left_face(-5.0)}, 0.0, 4.0);
  auto* inlet = exchange.find({1, 0});
  ASSERT_NE(inlet, nullptr);
  EXPECT_EQ(exchange.find({1, 1}), nullptr);
  EXPECT_EQ(exchange.missing(0.25)->step, 0U);
  for (int n = 0; n < 3; ++n)
    inlet->history.append(std::as_bytes(std::span<const double>(ramp_step(0.5 * n))));
  EXPECT_FALSE(exchange.missing(0.25));
  std::vector<eq6::FreeField> free_field(1);
  exchange.read(0.25, free_field);
  EXPECT_DOUBLE_EQ(free_field[0].velocity.y, 0.5);
  // n = (-1, 0): -rho c_p (1 - 0.25) - sxx + 100 and -rho c_s (1 - 0.5) - sxy + 7
  const eq6::Vector traction = exchange.faces()[0].traction({1.0, 1.0}, free_field[0]);
  EXPECT_DOUBLE_EQ(traction.x, -6.0 * 0.75 - 10.0 + 100.0);
  EXPECT_DOUBLE_EQ(traction.y, -3.0 * 0.5 - 30.0 + 7.0);
}

TEST(FaceExchange, AddsFieldsOfWavesWithSlownessesOfTheirOwn) {
  FieldDescription second = ramp();
  second.name = "total+vertical";
  second.slowness_x = 0.1;
  second.start_time = -1.0;
  FieldDescription other = ramp();
  other.name = "incident";
  ExchangedFace face = left_face(-5.0);
  face.position.x = 5.0; // half a second behind
  FaceExchange exchange({{"left", 1, {ramp(), other, second}}}, {left_face(-5.0), face}, 0.0, 3.0);
  EXPECT_EQ(exchange.find({1, 1}), nullptr);
  for (const std::uint32_t field : {0u, 2u})
    for (int n = 0; n < 5; ++n)
      exchange.find({1, field})
          ->history.append(
              std::as_bytes(std::span<const double>(ramp_step((field == 2 ? -1.0 : 0.0) + 0.5 * n))));
  std::vector<eq6::FreeField> free_field(2);
  exchange.read(0.75, free_field);
  EXPECT_DOUBLE_EQ(free_field[0].velocity.x, 0.75 + 0.75);
  EXPECT_DOUBLE_EQ(free_field[1].velocity.x, 0.75 + 0.25);
  EXPECT_DOUBLE_EQ(free_field[1].velocity.y, 2.0 * (0.75 + 0.25));
  EXPECT_DOUBLE_EQ(free_field[1].stress.xy, 60.0);
}

TEST(FaceExchange, CreditsGrowOnceAndUpToTheFieldsEnd) {
  FaceExchange exchange({{"left", 1, {ramp()}}}, {left_face(-5.0)}, 0.0, 4.0);
  const auto credits = exchange.new_credits();
  ASSERT_EQ(credits.size(), 1U);
  EXPECT_EQ(credits[0].steps, 9U);
  EXPECT_TRUE(exchange.new_credits().empty());
}

TEST(FaceExchange, AFrameIsBoundInStepsAndInBytes) {
  const auto steps = [](std::size_t points, std::uint32_t window_steps) {
    auto field = ramp();
    field.y.assign(points, 0.0);
    return steps_per_frame(field, window_steps);
  };
  constexpr std::size_t mebibyte = 1 << 20;
  EXPECT_EQ(steps(100, 64), 64U);
  EXPECT_EQ(steps(1000, 64), mebibyte / (1000 * 80));
  EXPECT_EQ(steps(10000, 64), 1U);
  EXPECT_EQ(steps(1'000'000, 64), 1U); // never less than a step
}

TEST(FaceExchange, WhatASourceMaySendAheadIsFourFrames) {
  auto field = ramp();
  field.y.clear();
  for (int i = 0; i < 1000; ++i)
    field.y.push_back(-10.0 + 0.01 * i);
  field.step_count = 100'000;
  field.steps_per_frame = steps_per_frame(field, 64);
  FaceExchange exchange({{"left", 1, {field}}}, {left_face(-5.0)}, 0.0, 4.0);
  const auto credits = exchange.new_credits();
  ASSERT_EQ(credits.size(), 1U);
  const std::uint64_t of_the_face = 3; // an interval has two ends, and time lies between two
  EXPECT_LE(credits[0].steps, 4 * field.steps_per_frame + of_the_face);
}

TEST(FaceExchange, RefusesWhatTheSourceDoesNotCover) {
  auto unknown = left_face(-5.0);
  unknown.field = "incident";
  EXPECT_THAT(refusal(unknown, 0.0, 4.0),
              HasSubstr("takes field 'incident' of source 'left', served are: left/total"));
  EXPECT_THAT(refusal(left_face(1.0), 0.0, 4.0), HasSubstr("source 'left' does not cover the domain"));
  EXPECT_THAT(refusal(left_face(-5.0), -0.1, 4.0), HasSubstr("serves field 'total' from 0 to 4 s"));
  EXPECT_THAT(refusal(left_face(-5.0), 0.0, 4.1), HasSubstr("from 0 to 4.1 s"));
  EXPECT_EQ(refusal(left_face(-5.0), 0.0, 4.0), "");
}

} // namespace
} // namespace tremolo::coupler
