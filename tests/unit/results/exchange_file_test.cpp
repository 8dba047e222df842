// Recorded exchanges: every bit comes back, what is cut short says so, and what is no such recording is
// refused.

#include "results/exchange_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <string>
#include <vector>

namespace tremolo::results {
namespace {

using ::testing::HasSubstr;

/// Numbers without any pattern.
std::vector<double> noise(std::size_t count, double seed) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(std::sin(1e4 * (static_cast<double>(i) + seed)) *
                     std::exp2(static_cast<double>(i % 40)));
  return values;
}

ExchangeDescription description(const std::string& mode) {
  const RecordedField total{.name = "total",
                            .levels = {-4.0, -2.0, -2.0, 0.0},
                            .x_reference = 1.0 / 3.0,
                            .slowness_x = 2e-3,
                            .start_time = -0.7,
                            .time_step = 0.1,
                            .step_count = 9000};
  RecordedField incident = total;
  incident.name = "incident";
  incident.levels = {-4.0};
  return {
      .session = "0123456789abcdef",
      .mode = mode,
      .case_text = "title = \"a case\"",
      .case_values = {{"motion.angle_deg", "15"}, {"motion.wave", "\"SV\""}},
      .sources = {{"left-base", 1, {"left", "base"}, {total, incident}}, {"right", 2, {"right"}, {total}}},
      .domain = "domain",
      .domain_number = 3,
      .faces = {.position = {0.0, -1.0, 9.0, -1.0},
                .normal = {-1.0, 0.0, 1.0, 0.0},
                .impedance = {3e5, 1e5, 3e5, 1e5},
                .static_traction = {1e3, 0.0, -1e3, 0.0},
                .source = {"left-base", "right"},
                .field = {"total", "total"}},
      .start_time = 0.0,
      .end_time = 2.0};
}

class ExchangeFile : public ::testing::Test {
protected:
  static constexpr std::size_t step_values = 4 * recorded_values;
  static constexpr std::size_t steps = 3000; // more than a chunk

  /// Frames of unequal length.
  void write(ExchangeWriter& writer) const {
    for (std::size_t first = 0, count = 1; first < steps;
         first += count, count = std::min(steps - first, count + 7))
      writer.source_frame(1, 0, {first, count, static_cast<std::uint32_t>(4'000'000'000U + first)},
                          std::span(field_).subspan(first * step_values, count * step_values));
    for (std::size_t step = 0; step < 3; ++step) {
      writer.velocity_frame({step, 1, 7}, std::span(velocities_).subspan(5 * step, 5));
      writer.traction_frame({step, 1, 8}, std::span(tractions_).subspan(14 * step, 14));
    }
  }

  tremolo::testing::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "exchange.h5";
  std::vector<double> field_ = noise(steps * step_values, 0.1);
  std::vector<double> velocities_ = noise(3 * 5, 0.2);
  std::vector<double> tractions_ = noise(3 * 14, 0.3);
};

TEST_F(ExchangeFile, ComesBackBitForBit) {
  {
    ExchangeWriter writer(file_, description("lockstep"));
    write(writer);
    writer.close("complete");
  }
  const ExchangeReader reader(file_);
  EXPECT_TRUE(reader.complete());
  const auto expected = description("lockstep");
  EXPECT_EQ(reader.description().session, expected.session);
  EXPECT_EQ(reader.description().case_values, expected.case_values);
  EXPECT_EQ(reader.description().case_text, expected.case_text);
  EXPECT_EQ(reader.description().faces.impedance, expected.faces.impedance);
  EXPECT_EQ(reader.description().faces.source, expected.faces.source);
  EXPECT_EQ(reader.source_of("base").name, "left-base");
  EXPECT_EQ(reader.source_of("right").fields.front().step_count, 9000U) << "as declared";

  const FreeFieldRecording right(file_, "right");
  ASSERT_EQ(right.fields().size(), 1U);
  EXPECT_EQ(right.fields().front().step_count, steps) << "as held";
  EXPECT_EQ(right.fields().front().levels, expected.sources[1].fields.front().levels);
  std::vector<double> step(step_values);
  for (const std::size_t n : {std::size_t{0}, std::size_t{1024}, steps - 1}) {
    right.read(0, n, step);
    EXPECT_TRUE(
        std::equal(step.begin(), step.end(), field_.begin() + static_cast<std::ptrdiff_t>(n * step_values)))
        << "step " << n;
  }
  const auto frames = reader.frames("right", "total");
  EXPECT_EQ(frames[1].step, 1U);
  EXPECT_EQ(frames[1].steps, 8U);
  EXPECT_EQ(frames[1].crc, 4'000'000'001U);
  EXPECT_EQ(reader.domain_steps(), 3U);
  EXPECT_EQ(reader.velocities(1), std::vector<double>(velocities_.begin() + 5, velocities_.begin() + 10));
  EXPECT_EQ(reader.tractions(2),
            (std::vector<double>{tractions_[28], tractions_[29], tractions_[35], tractions_[36]}));
  EXPECT_THROW(reader.velocities(3), std::out_of_range);
  EXPECT_EQ(FreeFieldRecording(file_, "left-base").fields().back().step_count, 0U);
}

TEST_F(ExchangeFile, WriterThatIsGoneLeavesWhatWasFlushed) {
  {
    ExchangeWriter writer(file_, description("lockstep"));
    write(writer);
    writer.flush();
  }
  {
    const ExchangeReader reader(file_);
    EXPECT_EQ(reader.status(), "running");
    EXPECT_FALSE(reader.complete());
    const FreeFieldRecording right(file_, "right");
    ASSERT_GT(right.fields().front().step_count, 2000U);
    std::vector<double> step(step_values);
    right.read(0, 2000, step);
    EXPECT_TRUE(std::equal(step.begin(), step.end(),
                           field_.begin() + 2000 * static_cast<std::ptrdiff_t>(step_values)));
  }
  mark_exchange(file_, "aborted at step 3: a test");
  EXPECT_EQ(ExchangeReader(file_).status(), "aborted at step 3: a test");
}

TEST_F(ExchangeFile, DamagedValuesAreFound) {
  {
    ExchangeWriter writer(file_, description("window"));
    writer.source_frame(1, 0, {0, steps, 1}, field_);
    writer.close("complete");
  }
  haddr_t address = 0;
  {
    const hid_t file = H5Fopen(file_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(file, "sources/right/total/velocity", H5P_DEFAULT);
    hsize_t size = 0;
    const hsize_t first[3] = {0, 0, 0};
    unsigned mask = 0;
    ASSERT_GE(H5Dget_chunk_info_by_coord(dataset, first, &mask, &address, &size), 0);
    H5Dclose(dataset);
    H5Fclose(file);
  }
  std::fstream raw(file_, std::ios::in | std::ios::out | std::ios::binary);
  raw.seekp(static_cast<std::streamoff>(address + 1000));
  raw.put('\x55').put('\xaa');
  raw.close();
  const FreeFieldRecording right(file_, "right");
  std::vector<double> step(step_values);
  EXPECT_THROW(right.read(0, 0, step), std::runtime_error);
}

TEST_F(ExchangeFile, OtherFilesAreRefusedByWhatTheyAre) {
  const auto refusal = [&](const auto& action) -> std::string {
    try {
      action();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "it was not refused";
  };
  { ExchangeWriter(file_, description("window")).close("complete"); }
  EXPECT_THAT(refusal([&] { FreeFieldRecording{file_}; }),
              HasSubstr("is no recording of a free field: the attribute content is \"exchange\""));
  const std::vector<double> values(step_values);
  const auto total = description("window").sources[1].fields.front();
  RecordedField one_step = total;
  one_step.step_count = 1;
  const FieldToRecord record{one_step, values};
  write_free_field_recording(folder_ / "field.h5", "", "", {&record, 1});
  EXPECT_THAT(refusal([&] { ExchangeReader{folder_ / "field.h5"}; }),
              HasSubstr("is no recording of an exchange"));
  EXPECT_THAT(refusal([&] { ExchangeReader(file_).source_of("top"); }),
              HasSubstr("no source of this exchange served the side 'top'"));
}

TEST_F(ExchangeFile, FramesOfAnotherSizeAreRefused) {
  ExchangeWriter writer(file_, description("window"));
  EXPECT_THROW(writer.source_frame(0, 1, {0, 2, 0}, noise(19, 0.0)), std::invalid_argument);
  EXPECT_THROW(writer.traction_frame({0, 1, 0}, tractions_), std::invalid_argument) << "window has none";
}

} // namespace
} // namespace tremolo::results
