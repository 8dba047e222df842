#pragma once

// Control messages: one JSON object each, rare and readable. Data frames travel on the same connection; the
// first byte distinguishes them ('{' or 'T').

#include "coupler/client/timeline.hpp"
#include "coupler/mapping/timing.hpp"
#include "coupler/wire/field.hpp"

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::coupler {

/// A control message: JOIN, INVITE, HELLO, WELCOME, REFUSE, READY, CREDIT, CHECKPOINT, BEAT, BYE or ABORT,
/// and its other keys.
struct Message {
  std::string type;
  nlohmann::json body = nlohmann::json::object();
};

std::string to_text(const Message& message);

/// @throws Error for bytes that are no JSON object with a known "type"
Message parse_message(std::span<const std::byte> bytes);

bool looks_like_message(std::span<const std::byte> bytes);

nlohmann::json to_json(const FieldDescription& field);
nlohmann::json to_json(const SourceDescription& source);
nlohmann::json to_json(const std::vector<ExchangedFace>& faces);
nlohmann::json to_json(const std::vector<PassTime>& passes);
nlohmann::json to_json(const TimelineReport& timeline);

/// The inverse functions; they check what they read.
/// @throws Error naming the missing or wrong key
FieldDescription field_from(const nlohmann::json& json);
SourceDescription source_from(const nlohmann::json& json);
std::vector<SourceDescription> sources_from(const Message& welcome);
std::vector<ExchangedFace> faces_from(const nlohmann::json& json);
std::vector<PassTime> passes_from(const nlohmann::json& json);
TimelineReport timeline_from(const nlohmann::json& json);

/// The session as in messages and on command lines: 16 hexadecimal digits.
std::string session_text(std::uint64_t session);

/// @throws std::invalid_argument for anything but 16 hexadecimal digits
std::uint64_t session_from(const std::string& text);

/// CRC-32, 8 hexadecimal digits: participants of a run must have read the same case.
std::string text_crc(std::string_view text);

} // namespace tremolo::coupler
