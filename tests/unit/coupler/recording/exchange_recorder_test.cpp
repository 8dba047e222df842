// The recorder behind the hub: frames come back as they were, what a source owes is missed, and a file that
// cannot be written ends the run or is noted once, as the case chose.

#include "coupler/recording/exchange_recorder.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/frame.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tremolo::coupler {
namespace {

using ::testing::HasSubstr;
using ::testing::Optional;

constexpr std::size_t levels = 3;
constexpr std::uint32_t step_values = levels * values_per_point;

ExchangeStart start(std::uint64_t needed) {
  const FieldDescription field{
      .name = "total", .y = {-2.0, -1.0, 0.0}, .start_time = -0.1, .time_step = 0.01, .step_count = 500};
  return {.session = 0xabcdef,
          .mode = Mode::lockstep,
          .window_steps = 4,
          .sources = {{"left-right-base", 1, {field}}},
          .needed_steps = {{needed}},
          .domain = "domain",
          .domain_number = 2,
          .faces = {{.position = {0.0, -1.0}, .source = "left-right-base", .field = "total"}},
          .start_time = 0.0,
          .end_time = 1.0};
}

std::vector<double> values(std::size_t count, double seed) {
  std::vector<double> list;
  for (std::size_t i = 0; i < count; ++i)
    list.push_back(std::sin(1e4 * (static_cast<double>(i) + seed)));
  return list;
}

std::vector<std::byte> source_frame(std::uint64_t step) {
  return encode({.session = 0xabcdef, .sender = 1, .step = step, .steps = 4, .count = step_values},
                values(4 * step_values, static_cast<double>(step)));
}

class Recorder : public ::testing::Test {
protected:
  RecorderOptions options(const std::string& file, OnFullDisk policy = OnFullDisk::stop) {
    return {.file = folder_ / file,
            .on_full_disk = policy,
            .case_text = "title = \"x\"",
            .case_values = {{"motion.wave", "\"SV\""}},
            .serves = {{"left-right-base", {"left", "right", "base"}}},
            .note = [&](const std::string& text) { notes_.push_back(text); }};
  }

  tremolo::testing::TemporaryFolder folder_;
  std::vector<std::string> notes_;
};

TEST_F(Recorder, FramesComeBackAsTheyWere) {
  ExchangeRecorder recorder(options("exchange.h5"));
  recorder.begin(start(8));
  for (const std::uint64_t step : {0U, 4U, 8U})
    recorder.frame(source_frame(step));
  const std::vector<double> velocity{0.25, 1.0, -2.0};
  recorder.frame(encode({.session = 0xabcdef, .sender = 2, .steps = 1, .count = 3}, velocity));
  recorder.frame(encode({.session = 0xabcdef, .steps = 1, .count = 7}, values(7, 0.5)));
  EXPECT_EQ(recorder.finish(std::nullopt), std::nullopt);

  const results::ExchangeReader reader(folder_ / "exchange.h5");
  EXPECT_EQ(reader.status(), "complete");
  EXPECT_EQ(reader.description().session, "0000000000abcdef");
  EXPECT_EQ(reader.velocities(0), velocity);
  const results::FreeFieldRecording field(folder_ / "exchange.h5", reader.source_of("base").name);
  std::vector<double> four(4 * step_values);
  const auto frames = reader.frames("left-right-base", "total");
  ASSERT_EQ(frames.size(), 3U);
  for (const auto& [first, steps, crc] : frames) {
    for (std::uint64_t i = 0; i < steps; ++i)
      field.read(0, first + i, std::span(four).subspan(i * step_values, step_values));
    EXPECT_EQ(
        crc,
        opened(
            encode({.session = 0xabcdef, .sender = 1, .step = first, .steps = 4, .count = step_values}, four))
            .crc);
  }
}

TEST_F(Recorder, WhatASourceHasNotSentIsMissed) {
  ExchangeRecorder recorder(options("exchange.h5"));
  recorder.begin(start(9));
  recorder.frame(source_frame(0));
  recorder.frame(source_frame(4));
  EXPECT_THAT(recorder.finish(std::nullopt),
              Optional(HasSubstr("source 'left-right-base' had sent 8 of 9 steps of field 'total'")));
  EXPECT_THAT(results::ExchangeReader(folder_ / "exchange.h5").status(),
              HasSubstr("aborted at step 0: source"));
}

TEST_F(Recorder, TheReasonOfTheRunIsThatOfTheRecording) {
  ExchangeRecorder recorder(options("exchange.h5"));
  recorder.begin(start(0));
  recorder.frame(encode({.session = 0xabcdef, .sender = 2, .steps = 2, .count = 3}, values(6, 0.0)));
  recorder.finish("'left' was killed\nits last lines");
  EXPECT_EQ(results::ExchangeReader(folder_ / "exchange.h5").status(),
            "aborted at step 2: 'left' was killed");
}

TEST_F(Recorder, ARunThatNeverExchangedLeavesNoFile) {
  ExchangeRecorder recorder(options("exchange.h5"));
  EXPECT_EQ(recorder.finish("no HELLO"), std::nullopt);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "exchange.h5"));
}

/// The file's folder is missing: writing fails at once.
TEST_F(Recorder, AFileThatCannotBeWrittenEndsTheRun) {
  ExchangeRecorder recorder(options("missing/exchange.h5"));
  try {
    recorder.begin(start(0));
    FAIL() << "the recording begins";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the exchange cannot be recorded any more"));
    EXPECT_THAT(error.what(), HasSubstr("missing/exchange.h5: cannot create the file"));
  }
  EXPECT_THAT(recorder.finish("ended by it"), Optional(HasSubstr("cannot create the file")));
}

TEST_F(Recorder, OrIsNotedOnce) {
  ExchangeRecorder recorder(options("missing/exchange.h5", OnFullDisk::go_on));
  recorder.begin(start(0));
  recorder.frame(source_frame(0));
  ASSERT_EQ(notes_.size(), 1U);
  EXPECT_THAT(notes_.front(), HasSubstr("the run goes on"));
  EXPECT_NE(recorder.finish(std::nullopt), std::nullopt);
}

} // namespace
} // namespace tremolo::coupler
