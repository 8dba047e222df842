// tremolo-recording serves a recording bit for bit, and refuses one that does not cover the case.

#include "coupler/conformance/source_probe.hpp"
#include "coupler/wire/frame.hpp"
#include "results/free_field_recording.hpp"
#include "scene/plan/service.hpp"
#include "tests/support/flat_case.hpp"
#include "tests/support/paths.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <variant>
#include <vector>

namespace tremolo {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string short_case() {
  using tremolo::testing::plus;
  using tremolo::testing::with;
  const auto text =
      with("time = 1.0", "time = 0.7", plus("[output]\nevery_s = 0.1\nhistory_every_s = 0.01\n"));
  return with("form = \"total\"", "form = \"incident\"", with("duration_s = 2.0", "duration_s = 0.5", text));
}

/// Numbers without any pattern, so that none can stand in the place of another; below 64, as free fields may
/// be.
std::vector<double> noise(std::size_t count, std::size_t seed) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(std::sin(1e4 * static_cast<double>(i + 7919 * seed)) *
                     std::exp2(static_cast<double>(i % 40) - 33.0));
  return values;
}

class Recording : public ::testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              fmt::format("tremolo_{}_{}", ::testing::UnitTest::GetInstance()->current_test_info()->name(),
                          ::getpid());
    fs::create_directories(folder_);
    std::ofstream(folder_ / "case.toml") << short_case();
  }
  void TearDown() override { fs::remove_all(folder_); }

  results::RecordedField field(const std::string& name, std::vector<double> levels) const {
    return {.name = name,
            .levels = std::move(levels),
            .x_reference = 3.0,
            .start_time = -0.013,
            .time_step = 0.01,
            .step_count = 61};
  }

  void write(const std::vector<results::RecordedField>& fields) {
    std::vector<results::FieldToRecord> records;
    for (const auto& f : fields)
      values_.push_back(noise(f.step_count * f.levels.size() * results::recorded_values, values_.size()));
    for (std::size_t i = 0; i < fields.size(); ++i)
      records.push_back({fields[i], values_[i]});
    results::write_free_field_recording(folder_ / "field.h5", "noise", "no ground at all", records);
  }

  coupler::ProbeOptions program() const {
    return {.command = {program_dir() + "/tremolo-recording", "--file", (folder_ / "field.h5").string()},
            .case_file = folder_ / "case.toml",
            .name = "left-right-base",
            .folder = folder_,
            .deadlines = {}};
  }

  /// Why the program does not say HELLO.
  std::string refusal() {
    coupler::SourceProbe probe(program());
    try {
      probe.hello();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "it was not refused";
  }

  fs::path folder_;
  std::vector<std::vector<double>> values_;
};

TEST_F(Recording, ArrivesBitForBit) {
  const std::vector fields{field("total", {-10.0, -7.3, -4.0, -4.0, 0.0}), field("incident", {-10.0})};
  write(fields);
  coupler::SourceProbe probe(program());
  const auto hello = probe.hello();
  ASSERT_EQ(hello.type, "HELLO");
  ASSERT_EQ(hello.body.at("fields").size(), 2U);
  coupler::SourceDescription source{"left", 1, {}};
  for (const auto& said : hello.body.at("fields"))
    source.fields.push_back(coupler::field_from(said));
  for (auto& served : source.fields)
    served.steps_per_frame = 64;
  probe.send({"WELCOME",
              {{"number", 1}, {"mode", "window"}, {"sources", nlohmann::json::array({to_json(source)})}}});
  for (std::uint32_t f = 0; f < 2; ++f) {
    const auto served = coupler::field_from(hello.body.at("fields").at(f));
    EXPECT_EQ(served.y, fields[f].levels);
    EXPECT_EQ(served.start_time, fields[f].start_time);
    EXPECT_EQ(served.time_step, fields[f].time_step);
    EXPECT_EQ(served.x_reference, fields[f].x_reference);
    ASSERT_EQ(served.step_count, 61U);
    probe.send({"CREDIT", {{"field", f}, {"steps", 61}}});
    std::optional<coupler::Incoming> incoming;
    while (!incoming || incoming->message)
      incoming = probe.receive(0.2);
    const auto frame =
        coupler::decode(incoming->frame(), {.session = probe.session(),
                                            .sender = 1,
                                            .field = f,
                                            .step = 0,
                                            .count = static_cast<std::uint32_t>(served.values_per_step()),
                                            .most_steps = 61});
    ASSERT_TRUE(std::holds_alternative<coupler::Frame>(frame)) << std::get<coupler::FrameError>(frame).text;
    const auto values = std::get<coupler::Frame>(frame).values();
    ASSERT_EQ(values.size(), values_[f].size());
    EXPECT_EQ(std::memcmp(values.data(), values_[f].data(), values.size() * sizeof(double)), 0);
  }
  probe.send({"BYE"});
  EXPECT_TRUE(probe.ends_within(2.0));
  EXPECT_TRUE(probe.process().succeeded());
}

TEST_F(Recording, TooShallowOrTooShortIsRefusedWithBothRanges) {
  write({field("total", {-9.0, 0.0}), field("incident", {-10.0})});
  EXPECT_THAT(refusal(),
              AllOf(HasSubstr("field 'total' is recorded from y = -9 to 0 m and from -0.013 to 0.587 s"),
                    HasSubstr("the case asks for it from y = -10 to 0 m and from 0 to 0.5 s")));
  auto late = field("total", {-10.0, 0.0});
  late.start_time = 0.1;
  values_.clear();
  write({late, field("incident", {-10.0})});
  EXPECT_THAT(
      refusal(),
      HasSubstr("from 0.1 to 0.7 s, but the case asks for it from y = -10 to 0 m and from 0 to 0.5 s"));
}

TEST_F(Recording, MissingFieldIsNamed) {
  write({field("total", {-10.0, 0.0})});
  EXPECT_THAT(refusal(), HasSubstr("the case asks for the field 'incident', recorded are: 'total'"));
}

TEST_F(Recording, FileThatIsNoRecordingIsRefused) {
  std::ofstream(folder_ / "field.h5") << "no HDF5";
  EXPECT_THAT(refusal(), HasSubstr("cannot open the recording"));
}

} // namespace
} // namespace tremolo
