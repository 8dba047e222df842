#include "base/text/text_file.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/handshake/messages.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

namespace tremolo::coupler {
namespace {

Message parse(const std::string& text) {
  return parse_message(std::as_bytes(std::span(text)));
}

TEST(Messages, RoundTrip) {
  const auto message = parse(to_text({"BEAT", {{"step", 7}}}));
  EXPECT_EQ(message.type, "BEAT");
  EXPECT_EQ(message.body.at("step"), 7);
}

TEST(Messages, FacesKeepEveryBit) {
  const std::vector<ExchangedFace> faces{{{1.0 / 3.0, -0.1},
                                          {{std::sqrt(0.5), -std::sqrt(0.5)}, 1e6 / 3.0, 0.7e6},
                                          {-1e5 / 7.0, 3.3},
                                          "left",
                                          "total"}};
  const auto again = faces_from(nlohmann::json::parse(to_json(faces).dump()));
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again[0].position.x, faces[0].position.x);
  EXPECT_EQ(again[0].dashpot.normal.y, faces[0].dashpot.normal.y);
  EXPECT_EQ(again[0].dashpot.impedance_p, faces[0].dashpot.impedance_p);
  EXPECT_EQ(again[0].dashpot.impedance_s, faces[0].dashpot.impedance_s);
  EXPECT_EQ(again[0].static_traction.x, faces[0].static_traction.x);
  EXPECT_EQ(again[0].field, "total");
}

TEST(Messages, WhatIsWrongIsToldInWordsOfOurOwn) {
  const auto told = [](const std::string& text) -> std::string {
    try {
      faces_from(parse(text).body.at("faces"));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(told("{\"type\": "), "control message: no JSON: it cannot be read at byte 10 of 9");
  EXPECT_EQ(told("{\"type\": \"READY\", \"faces\": [{}]}"), "face: the key 'position' is missing");
  EXPECT_EQ(told("{\"type\": \"READY\", \"faces\": [{\"position\": [1, \"a\"]}]}"),
            "face: 'position' is [1,\"a\"], expected numbers, but \"a\" stands in it");
  EXPECT_EQ(told("{\"type\": \"READY\", \"faces\": [7]}"), "face: 7 is no object with a key 'position'");
}

TEST(Messages, CountsAreWholeNumbers) {
  const auto count = [](const char* text) { return whole_at(nlohmann::json::parse(text), "n"); };
  EXPECT_EQ(count("{\"n\": 2000}"), 2000U);
  EXPECT_EQ(count("{\"n\": 2000.0}"), 2000U);
  EXPECT_EQ(count("{\"n\": 18446744073709551615}"), 18446744073709551615U);
  for (const char* text : {"{\"n\": -1}", "{\"n\": 2000.5}", "{\"n\": 1e300}", "{\"n\": \"7\"}", "{}", "[]",
                           "{\"n\": 99999999999999999999}"})
    EXPECT_THROW(count(text), Error) << text;
}

TEST(Messages, NonsenseIsRefused) {
  for (const char* text : {"{", "{}", "{\"type\": 3}", "{\"type\": \"HALLO\"}", "[1]"})
    EXPECT_THROW(parse(text), Error) << text;
}

TEST(Messages, FieldsThatCannotBeServedAreRefused) {
  const FieldDescription good{.name = "total", .y = {-1.0, 0.0}, .time_step = 0.1, .step_count = 2};
  EXPECT_NO_THROW(field_from(to_json(good)));
  auto bad = good;
  bad.y = {0.0, -1.0};
  EXPECT_THROW(field_from(to_json(bad)), Error);
  bad.y = {-1.0, 0.0, 0.0, 1.0}; // an interface
  EXPECT_NO_THROW(field_from(to_json(bad)));
  bad.y = {-1.0, 0.0, 0.0, 0.0};
  EXPECT_THROW(field_from(to_json(bad)), Error);
  bad = good;
  bad.time_step = 0.0;
  EXPECT_THROW(field_from(to_json(bad)), Error);
  bad = good;
  bad.step_count = 1;
  EXPECT_THROW(field_from(to_json(bad)), Error);
  bad = good;
  bad.slowness_x = std::numeric_limits<double>::infinity();
  EXPECT_THROW(field_from(to_json(bad)), Error);
  auto json = to_json(good);
  json.erase("slowness_x");
  EXPECT_THROW(field_from(json), Error);
}

TEST(Messages, SessionIsSixteenHexadecimalDigits) {
  EXPECT_EQ(session_from(session_text(0xfedcba9876543210)), 0xfedcba9876543210);
  EXPECT_EQ(session_text(1), "0000000000000001");
  for (const char* text : {"", "1", "00000000000000001", "000000000000000g", "0x00000000000001"})
    EXPECT_THROW(session_from(text), std::invalid_argument) << text;
}

TEST(Messages, CrcOfAFileIsTheCheckValueOfCrc32) {
  const auto file = std::filesystem::path(testing::TempDir()) / "tremolo_crc_check.txt";
  std::ofstream(file) << "123456789";
  EXPECT_EQ(text_crc(read_text_file(file)), "cbf43926");
  std::filesystem::remove(file);
  EXPECT_THROW(read_text_file(file), std::runtime_error);
}

/// What prints a value walks into it call by call: half a million brackets would end the hub with a full
/// stack.
TEST(Messages, NestedTooDeepAreRefused) {
  const std::string deep = std::string(500'000, '[') + std::string(500'000, ']');
  for (const std::string& text : {deep, R"({"type":"HELLO","protocol":)" + deep + "}"})
    EXPECT_THAT([&] { parse_message(std::as_bytes(std::span(text))); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("nested more than 32 deep")));
}

} // namespace
} // namespace tremolo::coupler
