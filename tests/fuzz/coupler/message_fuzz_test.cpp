// Whatever another process writes in a control message, and whatever becomes of the files of a checkpoint, is
// read, or refused with an Error in words of our own.

#include "coupler/hub/checkpoint_set.hpp"
#include "coupler/launch/invitation.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_mutator.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <string_view>

namespace tremolo::coupler {
namespace {

namespace fs = std::filesystem;

constexpr unsigned messages = tremolo::test_support::repetitions(20'000U);
constexpr unsigned damages = tremolo::test_support::repetitions(200U);

/// Deeper than any message.
constexpr std::string_view deep = "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[";

constexpr std::array<std::string_view, 25> tokens{deep,
                                                  "-1",
                                                  "2000.5",
                                                  "1e400",
                                                  "9007199254740993",
                                                  "18446744073709551616",
                                                  "NaN",
                                                  "null",
                                                  "true",
                                                  "\"\"",
                                                  "[]",
                                                  "{}",
                                                  "[[[[",
                                                  "{\"name\":",
                                                  ",",
                                                  ":",
                                                  "\"total\"",
                                                  "\\u0000",
                                                  "\xff",
                                                  "0",
                                                  "-0.0",
                                                  "\"fields\"",
                                                  "\"y\"",
                                                  "1.0",
                                                  "\"step_count\""};

constexpr const char* hello = R"({"type":"HELLO","protocol":2,"session":"0123456789abcdef","name":"left",)"
                              R"("role":"source","build":"b","units":"SI","case":"00000000","fields":[)"
                              R"({"name":"total","y":[-1.0,0.0],"x_reference":0.0,"slowness_x":0.0,)"
                              R"("start_time":0.0,"time_step":0.01,"step_count":2000}]})";
constexpr const char* ready =
    R"({"type":"READY","start_time":0.0,"end_time":1.0,"faces":[{"position":[0.0,1.0],"normal":[1.0,0.0],)"
    R"("impedance_p":1.0,"impedance_s":1.0,"static_traction":[0.0,0.0],"source":"left","field":"total"}]})";
constexpr const char* bye =
    R"({"type":"BYE","passes":[{"name":"fill","seconds":0.1}],"waiting":0.0,"timeline":{"slice":0.1,)"
    R"("activities":{"computing":[0.1,0.2]}}})";
constexpr const char* invite =
    R"({"type":"INVITE","session":"0123456789abcdef","case_text":"x","files":[{"path":"/a","bytes":1,)"
    R"("crc":"00000000"}],"connect_deadline":1.0,"step_deadline":1.0})";

void read_hello(const nlohmann::json& body) {
  for (const auto& field : list_at(body, "fields"))
    field_from(field);
}
void read_ready(const nlohmann::json& body) {
  faces_from(list_at(body, "faces"));
}
void read_bye(const nlohmann::json& body) {
  passes_from(list_at(body, "passes"));
  timeline_from(value_at(body, "timeline"));
}
void read_invite(const nlohmann::json& body) {
  invitation_from(body);
}

TEST(MessageFuzz, IsReadOrRefusedInWords) {
  unsigned refused = 0;
  for (const auto& [good, read] : {std::pair<std::string, void (*)(const nlohmann::json&)>{hello, read_hello},
                                   {ready, read_ready},
                                   {bye, read_bye},
                                   {invite, read_invite}}) {
    EXPECT_NO_THROW(read(parse_message(std::as_bytes(std::span(good))).body));
    for (unsigned seed = 0; seed < messages; ++seed) {
      const std::string text = tremolo::testing::TextMutator(seed, tokens)(good);
      try {
        read(parse_message(std::as_bytes(std::span(text))).body);
      } catch (const Error& error) {
        ++refused;
        ASSERT_EQ(std::string_view(error.what()).find("json.exception"), std::string_view::npos)
            << text << "\n"
            << error.what();
      } catch (const std::exception& error) {
        FAIL() << "seed " << seed << ": " << text << "\n" << error.what();
      }
    }
  }
  EXPECT_GT(refused, messages);
}

void damage(const fs::path& file, tremolo::testing::Draw& draw) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  in.close();
  const auto at = draw.below(bytes.size());
  switch (draw.below(4)) {
  case 0:
    fs::remove(file);
    return;
  case 1:
    bytes.resize(at);
    break;
  case 2:
    bytes += "more";
    break;
  default:
    bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1U << draw.below(8)));
  }
  std::ofstream(file, std::ios::binary) << bytes;
}

/// A set that was damaged anywhere is passed over, or has become one of another version; it is never taken.
TEST(CheckpointFuzz, ADamagedFileIsNeverTaken) {
  for (unsigned seed = 0; seed < damages; ++seed) {
    const tremolo::testing::TemporaryFolder folder;
    const fs::path checkpoints = folder / "checkpoints";
    for (const std::uint64_t step : {40U, 80U}) {
      const auto draft = draft_folder(checkpoints, step);
      fs::create_directories(draft);
      for (const char* file : {"domain.h5", "left.h5", "recording.h5"})
        std::ofstream(draft / file) << file << " of step " << step;
      publish({draft, step, 0.5, {.case_text = "case", .window_steps = 64}}, 10);
    }
    tremolo::testing::Draw draw(seed);
    const std::array<const char*, 4> files{"domain.h5", "left.h5", "recording.h5", "manifest.json"};
    const auto* file = files[draw.below(files.size())];
    damage(checkpoints / "0000000080" / file, draw);
    try {
      const auto found = find_sets(checkpoints);
      ASSERT_TRUE(found.newest) << "seed " << seed;
      EXPECT_EQ(found.newest->step, 40U) << "seed " << seed << ", " << file;
      EXPECT_THAT(found.damaged, ::testing::ElementsAre(::testing::HasSubstr("0000000080")));
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("in the checkpoint")) << "seed " << seed;
    }
  }
}

} // namespace
} // namespace tremolo::coupler
