#include "coupler/wire/messages.hpp"

#include "coupler/wire/crc32.hpp"
#include "coupler/wire/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <string_view>

namespace tremolo::coupler {

using nlohmann::json;

namespace {

constexpr std::array<std::string_view, 11> types{
    "JOIN", "INVITE", "HELLO", "WELCOME", "REFUSE", "READY", "CREDIT", "BEAT", "CHECKPOINT", "BYE", "ABORT"};

/// Reading JSON from another process: a missing key or a wrong type is its mistake, told in our words.
template <typename Read>
auto checked(std::string_view what, const Read& read) {
  try {
    return read();
  } catch (const json::exception& error) {
    throw Error(fmt::format("{}: {}", what, error.what()));
  } catch (const std::invalid_argument& error) {
    throw Error(fmt::format("{}: {}", what, error.what()));
  }
}

json pair(eq6::Vector v) {
  return json::array({v.x, v.y});
}

eq6::Vector vector_from(const json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>()};
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
  return checked("control message", [&] {
    Message message{{}, json::parse(text)};
    message.type = message.body.at("type").get<std::string>();
    if (std::find(types.begin(), types.end(), message.type) == types.end())
      throw Error(fmt::format("control message of unknown type '{}'", message.type));
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
  for (const auto& field : source.fields)
    fields.push_back(to_json(field));
  return {{"name", source.name}, {"number", source.number}, {"fields", std::move(fields)}};
}

json to_json(const std::vector<BoundaryFace>& faces) {
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
  return checked("field", [&] {
    FieldDescription field{.name = j.at("name").get<std::string>(),
                           .y = j.at("y").get<std::vector<double>>(),
                           .x_reference = j.at("x_reference").get<double>(),
                           .slowness_x = j.at("slowness_x").get<double>(),
                           .start_time = j.at("start_time").get<double>(),
                           .time_step = j.at("time_step").get<double>(),
                           .step_count = j.at("step_count").get<std::uint64_t>()};
    validate(field);
    return field;
  });
}

SourceDescription source_from(const json& j) {
  return checked("source", [&] {
    SourceDescription source{j.at("name").get<std::string>(), j.at("number").get<std::uint32_t>(), {}};
    for (const auto& field : j.at("fields"))
      source.fields.push_back(field_from(field));
    return source;
  });
}

std::vector<BoundaryFace> faces_from(const json& j) {
  return checked("face", [&] {
    std::vector<BoundaryFace> faces;
    for (const auto& f : j)
      faces.push_back({vector_from(f.at("position")),
                       {vector_from(f.at("normal")), f.at("impedance_p").get<double>(),
                        f.at("impedance_s").get<double>()},
                       vector_from(f.at("static_traction")),
                       f.at("source").get<std::string>(),
                       f.at("field").get<std::string>()});
    return faces;
  });
}

std::vector<PassTime> passes_from(const json& j) {
  return checked("passes", [&] {
    std::vector<PassTime> passes;
    for (const auto& p : j)
      passes.push_back({p.at("name").get<std::string>(), p.at("seconds").get<double>()});
    return passes;
  });
}

TimelineReport timeline_from(const json& j) {
  return checked("timeline", [&] {
    TimelineReport timeline{j.at("slice").get<double>(), {}};
    if (!(timeline.slice > 0.0))
      throw Error(fmt::format("timeline: slice is {} s, expected a positive number", timeline.slice));
    for (const auto& [activity, seconds] : j.at("activities").items())
      timeline.activities[activity] = seconds.get<std::vector<double>>();
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

std::string file_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.good() && !in.eof())
    throw Error(fmt::format("cannot read the case file {}", file.string()));
  return text;
}

std::string text_crc(std::string_view text) {
  return fmt::format("{:08x}", crc32(0, std::as_bytes(std::span(text))));
}

} // namespace tremolo::coupler
