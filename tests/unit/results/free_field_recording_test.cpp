// Recordings of free fields: every bit comes back, and what is no recording is refused by what is wrong with
// it.

#include "results/free_field_recording.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <string>
#include <unistd.h>
#include <vector>

namespace tremolo::results {
namespace {

using testing::HasSubstr;

class FreeFieldRecordingFile : public testing::Test {
protected:
  void TearDown() override { std::filesystem::remove(file_); }

  std::filesystem::path file_ =
      std::filesystem::path(testing::TempDir()) / fmt::format("tremolo_recording_{}.h5", ::getpid());
  RecordedField field_{.name = "total",
                       .levels = {-2.0, -1.0, -1.0, 0.1},
                       .x_reference = 1.0 / 3.0,
                       .slowness_x = 2e-3,
                       .start_time = -0.7,
                       .time_step = 0.1,
                       .step_count = 3};
};

TEST_F(FreeFieldRecordingFile, ComesBackStepByStep) {
  std::vector<double> values(3 * 4 * recorded_values);
  std::iota(values.begin(), values.end(), 0.1);
  const std::vector<FieldToRecord> records{{field_, values}};
  write_free_field_recording(file_, "title", "two layers", records);

  const FreeFieldRecording recording(file_);
  ASSERT_EQ(recording.fields().size(), 1U);
  const RecordedField& read = recording.fields().front();
  EXPECT_EQ(read.name, field_.name);
  EXPECT_EQ(read.levels, field_.levels);
  EXPECT_EQ(read.x_reference, field_.x_reference);
  EXPECT_EQ(read.slowness_x, field_.slowness_x);
  EXPECT_EQ(read.start_time, field_.start_time);
  EXPECT_EQ(read.time_step, field_.time_step);
  EXPECT_EQ(read.step_count, field_.step_count);
  std::vector<double> step(4 * recorded_values);
  for (const std::uint64_t n : {2U, 0U, 1U}) {
    recording.read(0, n, step);
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(n * step.size());
    EXPECT_TRUE(std::equal(step.begin(), step.end(), first)) << "step " << n;
  }
  EXPECT_THROW(recording.read(0, 3, step), std::out_of_range);
}

TEST_F(FreeFieldRecordingFile, ValuesThatDoNotFillTheShapeAreRefused) {
  const std::vector<double> values(119);
  const std::vector<FieldToRecord> records{{field_, values}};
  try {
    write_free_field_recording(file_, "", "", records);
    ADD_FAILURE() << "it was not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("field 'total': 119 values do not fill 3 steps at 4 levels of 10 values"));
  }
}

TEST_F(FreeFieldRecordingFile, MissingFileIsNamed) {
  try {
    const FreeFieldRecording recording(file_);
    ADD_FAILURE() << "it was not refused";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(file_.string() + ": cannot open the recording"));
  }
}

} // namespace
} // namespace tremolo::results
