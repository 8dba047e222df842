// Checkpoint files: every bit comes back; what is damaged or belongs to something else is refused with both
// values. A recording goes on from a checkpoint as if it had never stopped.

#include "results/checkpoint_file.hpp"
#include "results/exchange_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <limits>

namespace tremolo::results {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const CheckpointIdentity identity{"left", "0123abcd", 420};
const std::vector<double> numbers{1.0 / 3.0, -0.0, std::numeric_limits<double>::denorm_min(), 1e300};
const std::vector<std::uint64_t> integers{0, 1, ~std::uint64_t{0}};

class CheckpointFile : public ::testing::Test {
protected:
  void write() const {
    CheckpointWriter writer(file, identity);
    writer.write("numbers", numbers);
    writer.write("integers", integers);
    writer.write("nothing", std::vector<double>{});
    writer.close();
  }

  std::string refusal(const CheckpointIdentity& expected) const {
    try {
      const CheckpointReader reader(file, expected);
      static_cast<void>(reader.numbers("numbers"));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "taken";
  }

  testing::TemporaryFolder folder;
  std::filesystem::path file = folder / "left.h5";
};

TEST_F(CheckpointFile, GivesEveryBitBack) {
  write();
  const CheckpointReader reader(file, identity);
  const auto read = reader.numbers("numbers");
  ASSERT_EQ(read, numbers);
  EXPECT_TRUE(std::signbit(read[1]));
  EXPECT_EQ(reader.integers("integers"), integers);
  EXPECT_TRUE(reader.numbers("nothing").empty());
  EXPECT_THROW(static_cast<void>(reader.numbers("no such array")), std::runtime_error);
}

TEST_F(CheckpointFile, OfSomethingElseIsRefusedWithBothValues) {
  write();
  EXPECT_THAT(refusal({"right", identity.case_crc, 420}),
              AllOf(HasSubstr("participant = left"), HasSubstr("this run has right")));
  EXPECT_THAT(refusal({"left", "ffffffff", 420}), AllOf(HasSubstr("0123abcd"), HasSubstr("ffffffff")));
  EXPECT_THAT(refusal({"left", identity.case_crc, 421}), AllOf(HasSubstr("420"), HasSubstr("421")));
  EXPECT_EQ(refusal(identity), "taken");
}

TEST_F(CheckpointFile, OfAnotherSchemaIsRefusedWithBothVersions) {
  write();
  const hid_t open = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t attribute = H5Aopen(open, "schema_version", H5P_DEFAULT);
  const hid_t type = H5Aget_type(attribute);
  H5Awrite(attribute, type, "9.9");
  H5Tclose(type);
  H5Aclose(attribute);
  H5Fclose(open);
  EXPECT_THAT(refusal(identity),
              AllOf(HasSubstr("schema_version = 9.9"), HasSubstr(std::string(checkpoint_schema_version))));
}

TEST_F(CheckpointFile, DamagedOrCutShortIsRefused) {
  write();
  std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
  std::string all{std::istreambuf_iterator<char>(bytes), {}};
  const auto at = all.find(std::string(reinterpret_cast<const char*>(&numbers.back()), sizeof(double)));
  ASSERT_NE(at, std::string::npos);
  bytes.clear();
  bytes.seekp(static_cast<std::streamoff>(at));
  bytes.put(static_cast<char>(all[at] ^ 1));
  bytes.close();
  EXPECT_THAT(refusal(identity), HasSubstr(file.string()));
  std::filesystem::resize_file(file, all.size() / 2);
  EXPECT_THAT(refusal(identity), HasSubstr(file.string()));
  std::filesystem::remove(file);
  EXPECT_THAT(refusal(identity), HasSubstr(file.string()));
}

TEST_F(CheckpointFile, AFileIsSetAsideOnceUntilAllOfItIsTakenOver) {
  std::ofstream(file) << "first";
  const auto before = set_aside(file);
  EXPECT_FALSE(std::filesystem::exists(file));
  std::ofstream(file) << "second, half taken over";
  EXPECT_EQ(set_aside(file), before);
  std::ifstream in(before);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "first");
}

ExchangeDescription lockstep_run() {
  const RecordedField field{.name = "total", .levels = {-1.0, 0.0}, .time_step = 0.1, .step_count = 9000};
  return {.session = "0123456789abcdef",
          .mode = "lockstep",
          .case_text = "title = \"a case\"",
          .case_values = {},
          .sources = {{"left", 1, {"left"}, {field}}},
          .domain = "domain",
          .domain_number = 2,
          .faces = {.position = {0.0, -1.0},
                    .normal = {-1.0, 0.0},
                    .impedance = {3e5, 1e5},
                    .static_traction = {1e3, 0.0},
                    .source = {"left"},
                    .field = {"total"}},
          .start_time = 0.0,
          .end_time = 2.0};
}

void record(ExchangeWriter& writer, std::uint64_t first, std::uint64_t end) {
  for (std::uint64_t step = first; step < end; ++step) {
    const auto t = static_cast<double>(step);
    writer.velocity_frame({step, 1, 17}, std::vector{t, std::sin(t), std::cos(t)});
    writer.traction_frame({step, 1, 18}, std::vector{t, -t, std::sin(t), 0.0, 1.0, 2.0, 3.0});
  }
}

TEST_F(CheckpointFile, ARecordingGoesOnFromItAndForgetsWhatCameAfter) {
  constexpr std::uint64_t checkpoint = 2500; // two whole chunks and a part
  constexpr std::uint64_t end = 5000;
  const auto recording = folder / "exchange.h5";
  {
    ExchangeWriter writer(recording, lockstep_run());
    record(writer, 0, checkpoint);
    CheckpointWriter saved(file, identity);
    writer.save(saved);
    saved.close();
    record(writer, checkpoint, checkpoint + 1500);
    writer.flush(); // and dies
  }
  ExchangeWriter writer(recording.string() + ".new", lockstep_run());
  writer.take_over(recording, {file, identity});
  record(writer, checkpoint, end);
  writer.close("complete");

  const ExchangeReader read(recording.string() + ".new");
  ASSERT_EQ(read.domain_steps(), end);
  const auto frames = read.frames("domain", "velocity");
  ASSERT_EQ(frames.size(), end);
  ASSERT_EQ(read.frames("domain", "traction").size(), end);
  for (std::uint64_t step = 0; step < end; ++step) {
    const auto t = static_cast<double>(step);
    ASSERT_EQ(read.velocities(step), (std::vector{t, std::sin(t), std::cos(t)}));
    ASSERT_EQ(read.tractions(step), (std::vector{t, -t}));
    ASSERT_EQ(frames[step].step, step);
  }
}

} // namespace
} // namespace tremolo::results
