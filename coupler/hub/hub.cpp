#include "coupler/hub/hub.hpp"

#include "coupler/hub/case_difference.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/sockets.hpp"

#include <algorithm>
#include <cerrno>
#include <exception>
#include <fmt/format.h>

namespace tremolo::coupler {

using nlohmann::json;

namespace {

constexpr double beat_interval_s = 0.25;

std::optional<ClientGate> gate_of(zmq::context_t& context, const HubOptions& options) {
  if (options.keys.empty())
    return std::nullopt;
  std::map<std::string, std::string> allowed;
  for (const auto& participant : options.participants)
    if (participant.elsewhere || options.outer_endpoint.empty())
      if (const auto [other, fresh] =
              allowed.try_emplace(read_public_key(options.keys, participant.name), participant.name);
          !fresh)
        throw Error(
            fmt::format("{0}.public and {1}.public in {2} hold the same key: each participant needs its "
                        "own",
                        other->second, participant.name, options.keys.string()));
  return std::optional<ClientGate>(std::in_place, context, std::move(allowed));
}

zmq::socket_t listening(zmq::context_t& context, const std::string& endpoint, const HubOptions& options) {
  std::optional<CurveKeys> keys;
  if (!options.keys.empty() && options.outer_endpoint.empty())
    keys = read_keys(options.keys, hub_key);
  try {
    return bound_router(context, endpoint, keys);
  } catch (const zmq::error_t& error) {
    throw Error(fmt::format("the hub cannot listen at '{}': {}", endpoint, error.what()));
  }
}

} // namespace

std::string_view name(Role role) {
  return role == Role::source ? "source" : "domain";
}

Hub::Hub(zmq::context_t& context, const std::string& endpoint, HubOptions options)
    : options_(std::move(options)), gate_(gate_of(context, options_)),
      socket_(listening(context, endpoint, options_)), endpoint_(socket_.get(zmq::sockopt::last_endpoint)),
      start_(Clock::now()), last_beat_(start_) {
  if (!options_.outer_endpoint.empty())
    listen_to_others();
  for (const auto& expected : options_.participants) {
    if (find_name(expected.name) != nullptr)
      throw Error(fmt::format("two participants are called '{}'", expected.name));
    participants_.push_back({.expected = expected,
                             .number = static_cast<std::uint32_t>(participants_.size() + 1),
                             .routing_id = {},
                             .build = {},
                             .last_heard = start_,
                             .pace = {},
                             .fields = {},
                             .outlets = {}});
  }
  const auto domains = std::count_if(participants_.begin(), participants_.end(),
                                     [](const auto& p) { return p.expected.role == Role::domain; });
  if (domains != 1)
    throw Error(fmt::format("a run has one domain, {} were given", domains));
}

void Hub::take_messages() {
  if (gate_)
    gate_->answer();
  for (;;) {
    zmq::message_t routing_id;
    if (!socket_.recv(routing_id, zmq::recv_flags::dontwait))
      return;
    zmq::message_t raw;
    bool whole = routing_id.more() && socket_.recv(raw, zmq::recv_flags::dontwait).has_value();
    for (zmq::message_t rest; whole && raw.more() && socket_.recv(rest, zmq::recv_flags::dontwait);)
      if (whole = false; !rest.more())
        break;
    if (whole && !failure_)
      take(routing_id.to_string(), raw);
  }
}

void Hub::take(const std::string& routing_id, zmq::message_t& raw) {
  const std::span<const std::byte> bytes(static_cast<const std::byte*>(raw.data()), raw.size());
  auto* participant = find_routing_id(routing_id);
  try {
    if (!looks_like_message(bytes)) {
      if (participant == nullptr)
        options_.note(fmt::format("ignored {} bytes from a stranger that has not said HELLO", bytes.size()));
      else if (participant->expected.role == Role::source)
        take_source_frame(*participant, raw);
      else
        take_velocities(*participant, bytes);
      return;
    }
    const Message message = parse_message(bytes);
    if (participant != nullptr)
      take_message(*participant, message);
    else if (message.type == "JOIN")
      take_join(routing_id, message.body, raw);
    else if (message.type == "HELLO" && !has_foreign_key(routing_id, message.body, raw))
      take_hello(routing_id, message);
    else if (message.type != "HELLO" && !is_word_of_usher(routing_id, message))
      refuse(routing_id, fmt::format("{} before HELLO", message.type));
  } catch (const std::exception& error) {
    if (participant == nullptr)
      refuse(routing_id, error.what());
    else
      fail(participant->expected.name,
           fmt::format("{} '{}' sent nonsense: {}", name(participant->expected.role),
                       participant->expected.name, error.what()));
  }
}

void Hub::take_hello(const std::string& routing_id, const Message& message) {
  const json& hello = message.body;
  const auto claimed = hello.at("name").get<std::string>();
  if (const auto session = hello.at("session").get<std::string>();
      session != session_text(options_.session)) {
    refuse(routing_id, fmt::format("'{}' belongs to session {}, this run is {}", claimed, session,
                                   session_text(options_.session)));
    return;
  }
  auto* participant = find_name(claimed);
  if (participant == nullptr) {
    refuse(routing_id, fmt::format("this run has no participant '{}'", claimed));
    return;
  }
  if (!participant->routing_id.empty()) {
    refuse(routing_id,
           fmt::format("'{}' is already taking part in this run; a second one was refused", claimed));
    return;
  }
  if (const auto reason = objection(*participant, hello)) {
    send_to(routing_id, {"REFUSE", {{"reason", *reason}}});
    fail(claimed, *reason);
    return;
  }
  participant->routing_id = routing_id;
  participant->build = hello.at("build").get<std::string>();
  participant->last_heard = Clock::now();
  if (participant->expected.role == Role::source)
    for (const auto& field : hello.at("fields")) {
      participant->fields.push_back(field_from(field));
      require_fits(frame_header_size + sizeof(double) * participant->fields.back().values_per_step());
    }
  participant->outlets.resize(participant->fields.size());
  if (options_.resume)
    load_source(*participant);
  if (std::none_of(participants_.begin(), participants_.end(),
                   [](const auto& p) { return p.routing_id.empty(); }))
    welcome_all();
}

std::optional<std::string> Hub::objection(const Participant& participant, const json& hello) const {
  const auto differs = [&](const char* key, const std::string& expected) -> std::optional<std::string> {
    const std::string found =
        hello.at(key).is_string() ? hello.at(key).get<std::string>() : hello.at(key).dump();
    if (found == expected)
      return std::nullopt;
    return fmt::format("'{}' (build {}) says {} = {}, the hub (build {}) has {}", participant.expected.name,
                       hello.at("build").get<std::string>(), key, found, TREMOLO_VERSION, expected);
  };
  for (const auto& [key, expected] :
       {std::pair<const char*, std::string>{"protocol", std::to_string(protocol_version)},
        {"role", std::string(name(participant.expected.role))},
        {"units", "SI"},
        {"case", text_crc(options_.case_text)}})
    if (auto difference = differs(key, expected)) {
      if (key == std::string_view("case") && hello.contains("case_text"))
        *difference += "; " + case_difference(hello.at("case_text").get<std::string>(), options_.case_text);
      return difference;
    }
  return std::nullopt;
}

void Hub::welcome_all() {
  welcomed_ = true;
  timeline_ = Timeline();
  json list = json::array();
  for (const auto& source : sources())
    list.push_back(to_json(source));
  for (auto& participant : participants_) {
    participant.pace.asked();
    send(participant, {"WELCOME",
                       {{"number", participant.number},
                        {"mode", name(options_.mode)},
                        {"window_steps", options_.window_steps},
                        {"sources", list}}});
  }
}

void Hub::take_message(Participant& participant, const Message& message) {
  const auto& [type, body] = message;
  const bool from_domain = participant.expected.role == Role::domain;
  participant.last_heard = Clock::now();
  if (type == "ABORT")
    fail(participant.expected.name, body.value("reason", "no reason given"));
  else if (type == "BEAT")
    take_beat(participant, body);
  else if (type == "BYE" && (from_domain || dismissed_))
    take_bye(participant, body);
  else if (type == "READY" && from_domain && welcomed_ && !ready_)
    take_ready(participant, body);
  else if (type == "CREDIT" && from_domain && ready_ && options_.mode == Mode::window)
    take_credit(body);
  else if (type == "CHECKPOINT" && from_domain && ready_)
    take_checkpoint(body);
  else
    throw Error(fmt::format("{} was not expected now", type));
}

void Hub::take_bye(Participant& participant, const json& body) {
  participant.left = true;
  reports_[participant.expected.name] = {passes_from(body.at("passes")),
                                         body.at("waiting").get<double>(),
                                         body.value("particle_updates", 0.0),
                                         {}};
  auto& report = reports_[participant.expected.name];
  if (const auto timeline = body.find("timeline"); timeline != body.end())
    report.timeline = timeline_from(*timeline);
  if (participant.expected.role != Role::domain)
    return;
  report.timeline.resolve_waits("hub", timeline_.report());
  wait_.reset();
  request_needed_steps();
  dismiss_sources();
}

bool Hub::finished() const {
  return std::all_of(participants_.begin(), participants_.end(), [](const auto& p) { return p.left; });
}

bool Hub::has_left(const std::string& participant) const {
  return reports_.contains(participant);
}

void Hub::tick() {
  if (failure_)
    return;
  if (!welcomed_) {
    check_connect_deadline();
    return;
  }
  check_domain_deadline();
  check_source_deadline();
  if (seconds_since(last_beat_) < beat_interval_s)
    return;
  last_beat_ = Clock::now();
  const std::string beat = to_text({"BEAT"});
  for (auto& participant : participants_)
    if (!participant.left)
      watch_line(participant, send_bytes(participant.routing_id, std::as_bytes(std::span(beat))));
}

void Hub::abort(const std::string& reason) {
  const std::string text = to_text({"ABORT", {{"reason", reason}}});
  // Those who are gone already cannot be told.
  for (const auto& participant : participants_)
    if (!participant.routing_id.empty() && !participant.left)
      send_bytes(participant.routing_id, std::as_bytes(std::span(text)));
}

void Hub::refuse(const std::string& routing_id, const std::string& reason) {
  options_.note("refused: " + reason);
  send_to(routing_id, {"REFUSE", {{"reason", reason}}});
}

void Hub::fail(const std::string& participant, const std::string& text) {
  if (!failure_)
    failure_ = Failure{participant, text};
}

void Hub::send(const Participant& participant, const Message& message) {
  send_to(participant.routing_id, message);
}

bool Hub::send_to(const std::string& routing_id, const Message& message) {
  const std::string text = to_text(message);
  return send_bytes(routing_id, std::as_bytes(std::span(text)));
}

bool Hub::send_bytes(const std::string& routing_id, std::span<const std::byte> bytes) {
  zmq::message_t raw(bytes.data(), bytes.size());
  return send_raw(routing_id, raw);
}

bool Hub::send_raw(const std::string& routing_id, zmq::message_t& raw) {
  require_fits(raw.size());
  try {
    socket_.send(zmq::const_buffer(routing_id.data(), routing_id.size()),
                 zmq::send_flags::sndmore | zmq::send_flags::dontwait);
    socket_.send(raw, zmq::send_flags::dontwait);
    return true;
  } catch (const zmq::error_t& error) {
    // It is gone: its BYE is on its way, or its process's end will be seen.
    if (error.num() != EHOSTUNREACH)
      throw;
    return false;
  }
}

Hub::Participant* Hub::find_name(const std::string& wanted) {
  const auto p = std::find_if(participants_.begin(), participants_.end(),
                              [&](const auto& q) { return q.expected.name == wanted; });
  return p == participants_.end() ? nullptr : &*p;
}

Hub::Participant* Hub::find_routing_id(const std::string& routing_id) {
  const auto p = std::find_if(participants_.begin(), participants_.end(),
                              [&](const auto& q) { return q.routing_id == routing_id; });
  return p == participants_.end() ? nullptr : &*p;
}

Hub::Participant& Hub::domain() {
  return *std::find_if(participants_.begin(), participants_.end(),
                       [](const auto& p) { return p.expected.role == Role::domain; });
}

std::vector<SourceDescription> Hub::sources() const {
  std::vector<SourceDescription> list;
  for (const auto& p : participants_)
    if (p.expected.role == Role::source)
      list.push_back({p.expected.name, p.number, p.fields});
  return list;
}

} // namespace tremolo::coupler
