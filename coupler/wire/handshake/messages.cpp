#include "coupler/wire/handshake/messages.hpp"

#include "base/crc32.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/handshake/json_keys.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <string_view>

namespace tremolo::coupler {

using nlohmann::json;

namespace {

constexpr std::array<std::string_view, 11> types{
    "JOIN", "INVITE", "HELLO", "WELCOME", "REFUSE", "READY", "CREDIT", "BEAT", "CHECKPOINT", "BYE", "ABORT"};

/// Reports what is wrong with a message, and in which part of it.
template <typename Read>
auto within(std::string_view what, const Read& read) {
  try {
    return read();
  } catch (const std::exception& error) {
    throw Error(fmt::format("{}: {}", what, error.what()));
  }
}

json pair(eq6::Vector v) {
  return json::array({v.x, v.y});
}

eq6::Vector vector_at(const json& object, const char* key) {
  const auto numbers = numbers_at(object, key);
  if (numbers.size() != 2)
    throw Error(fmt::format("'{}' has {} numbers, expected 2", key, numbers.size()));
  return {numbers[0], numbers[1]};
}

} // namespace

std::string to_text(const Message& message) {
  json all = message.body;
  all["type"] = message.type;
  return all.dump(-1, ' ', false, json::error_handler_t::replace); // a case file may hold any bytes
}

bool looks_like_message(std::span<const std::byte> bytes) {
  return !bytes.empty() && bytes.front() == std::byte{'{'};
}

Message parse_message(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return within("control message", [&] {
    Message message{{}, parsed_json(text)};
    message.type = text_at(message.body, "type");
    if (std::ranges::find(types, message.type) == types.end())
      throw Error(fmt::format("its type '{}' is unknown", message.type));
    return message;
  });
}

json to_json(const FieldDescription& field) {
  return {{"name", field.name},
          {"y", field.y},
          {"x_reference", field.x_reference},
          {"slowness_x", field.slowness_x},
          {"start_time", field.start_time},
          {"time_step", field.time_step},
          {"step_count", field.step_count}};
}

json to_json(const SourceDescription& source) {
  json fields = json::array();
  for (const auto& field : source.fields) {
    fields.push_back(to_json(field));
    fields.back()["steps_per_frame"] = field.steps_per_frame;
  }
  return {{"name", source.name}, {"number", source.number}, {"fields", std::move(fields)}};
}

json to_json(const std::vector<ExchangedFace>& faces) {
  json list = json::array();
  for (const auto& face : faces)
    list.push_back({{"position", pair(face.position)},
                    {"normal", pair(face.dashpot.normal)},
                    {"impedance_p", face.dashpot.impedance_p},
                    {"impedance_s", face.dashpot.impedance_s},
                    {"static_traction", pair(face.static_traction)},
                    {"source", face.source},
                    {"field", face.field}});
  return list;
}

json to_json(const std::vector<PassTime>& passes) {
  json list = json::array();
  for (const auto& pass : passes)
    list.push_back({{"name", pass.name}, {"seconds", pass.seconds}});
  return list;
}

json to_json(const TimelineReport& timeline) {
  return {{"slice", timeline.slice}, {"activities", timeline.activities}};
}

FieldDescription field_from(const json& j) {
  return within("field", [&] {
    FieldDescription field{.name = text_at(j, "name"),
                           .y = numbers_at(j, "y"),
                           .x_reference = number_at(j, "x_reference"),
                           .slowness_x = number_at(j, "slowness_x"),
                           .start_time = number_at(j, "start_time"),
                           .time_step = number_at(j, "time_step"),
                           .step_count = whole_at(j, "step_count")};
    validate(field);
    return field;
  });
}

SourceDescription source_from(const json& j) {
  return within("source", [&] {
    SourceDescription source{text_at(j, "name"), whole_32_at(j, "number"), {}};
    for (const auto& said : list_at(j, "fields")) {
      auto& field = source.fields.emplace_back(field_from(said));
      field.steps_per_frame = whole_32_at(said, "steps_per_frame");
      if (field.steps_per_frame == 0)
        throw Error(fmt::format("'steps_per_frame' of field '{}' is 0, expected 1 or more", field.name));
    }
    return source;
  });
}

std::vector<SourceDescription> sources_from(const Message& welcome) {
  std::vector<SourceDescription> sources;
  for (const auto& source : list_at(welcome.body, "sources"))
    sources.push_back(source_from(source));
  return sources;
}

std::vector<ExchangedFace> faces_from(const json& j) {
  return within("face", [&] {
    std::vector<ExchangedFace> faces;
    for (const auto& f : j)
      faces.push_back({vector_at(f, "position"),
                       {vector_at(f, "normal"), number_at(f, "impedance_p"), number_at(f, "impedance_s")},
                       vector_at(f, "static_traction"),
                       text_at(f, "source"),
                       text_at(f, "field")});
    return faces;
  });
}

std::vector<PassTime> passes_from(const json& j) {
  return within("passes", [&] {
    std::vector<PassTime> passes;
    for (const auto& p : j)
      passes.push_back({text_at(p, "name"), number_at(p, "seconds")});
    return passes;
  });
}

TimelineReport timeline_from(const json& j) {
  return within("timeline", [&] {
    TimelineReport timeline{number_at(j, "slice"), {}};
    if (!(timeline.slice > 0.0))
      throw Error(fmt::format("slice is {} s, expected a positive number", timeline.slice));
    const json& activities = value_at(j, "activities");
    for (const auto& [activity, seconds] : activities.items())
      timeline.activities[activity] = numbers_at(activities, activity.c_str());
    return timeline;
  });
}

std::string session_text(std::uint64_t session) {
  return fmt::format("{:016x}", session);
}

std::uint64_t session_from(const std::string& text) {
  std::uint64_t session = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), session, 16);
  if (text.size() != 16 || error != std::errc{} || end != text.data() + text.size())
    throw std::invalid_argument(fmt::format("session '{}' is not 16 hexadecimal digits", text));
  return session;
}

std::string text_crc(std::string_view text) {
  return fmt::format("{:08x}", crc32(0, std::as_bytes(std::span(text))));
}

} // namespace tremolo::coupler
