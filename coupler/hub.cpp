#include "coupler/hub.hpp"

#include "coupler/error.hpp"
#include "coupler/sockets.hpp"

#include <algorithm>
#include <cerrno>
#include <exception>
#include <fmt/format.h>

namespace tremolo::coupler {

using nlohmann::json;

namespace {

constexpr double beat_interval_s = 0.25;

zmq::socket_t bind(zmq::context_t& context, const std::string& endpoint) {
  try {
    return bound_router(context, endpoint);
  } catch (const zmq::error_t& error) {
    throw Error(fmt::format("the hub cannot listen at '{}': {}", endpoint, error.what()));
  }
}

} // namespace

std::string_view name(Role role) {
  return role == Role::source ? "source" : "domain";
}

Hub::Hub(zmq::context_t& context, const std::string& endpoint, HubOptions options)
    : options_(std::move(options)), socket_(bind(context, endpoint)), start_(Clock::now()),
      last_beat_(start_) {
  for (const auto& expected : options_.participants) {
    if (find_name(expected.name) != nullptr)
      throw Error(fmt::format("two participants are called '{}'", expected.name));
    participants_.push_back({.expected = expected,
                             .number = static_cast<std::uint32_t>(participants_.size() + 1),
                             .routing_id = {},
                             .build = {},
                             .last_heard = start_,
                             .fields = {},
                             .outlets = {}});
  }
  const auto domains = std::count_if(participants_.begin(), participants_.end(),
                                     [](const auto& p) { return p.expected.role == Role::domain; });
  if (domains != 1)
    throw Error(fmt::format("a run has one domain, {} were given", domains));
}

std::string Hub::endpoint() const {
  return socket_.get(zmq::sockopt::last_endpoint);
}

void Hub::take_messages() {
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
      take(routing_id.to_string(), {static_cast<const std::byte*>(raw.data()), raw.size()});
  }
}

void Hub::take(const std::string& routing_id, std::span<const std::byte> bytes) {
  auto* participant = find_routing_id(routing_id);
  try {
    if (!looks_like_message(bytes)) {
      if (participant == nullptr)
        options_.note(fmt::format("ignored {} bytes from a stranger that has not said HELLO", bytes.size()));
      else if (participant->expected.role == Role::source)
        take_source_frame(*participant, bytes);
      else
        take_velocities(*participant, bytes);
      return;
    }
    const Message message = parse_message(bytes);
    if (participant != nullptr)
      take_message(*participant, message);
    else if (message.type == "HELLO")
      take_hello(routing_id, message);
    else
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
    refuse(routing_id, *reason);
    fail(claimed, *reason);
    return;
  }
  participant->routing_id = routing_id;
  participant->build = hello.at("build").get<std::string>();
  participant->last_heard = Clock::now();
  if (participant->expected.role == Role::source)
    for (const auto& field : hello.at("fields"))
      participant->fields.push_back(field_from(field));
  participant->outlets.resize(participant->fields.size());
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
        {"case", options_.case_crc}})
    if (auto difference = differs(key, expected))
      return difference;
  return std::nullopt;
}

void Hub::welcome_all() {
  welcomed_ = true;
  json list = json::array();
  for (const auto& source : sources())
    list.push_back(to_json(source));
  for (auto& participant : participants_) {
    participant.last_heard = Clock::now();
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
  else
    throw Error(fmt::format("{} was not expected now", type));
}

void Hub::take_bye(Participant& participant, const json& body) {
  participant.left = true;
  reports_[participant.expected.name] = {passes_from(body.at("passes")), body.at("waiting").get<double>(),
                                         body.value("particle_updates", 0.0)};
  if (participant.expected.role != Role::domain)
    return;
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
  // A participant that is too busy to read does not need them: an answer that does not get out is no failure
  // here.
  const std::string beat = to_text({"BEAT"});
  for (const auto& participant : participants_)
    if (!participant.left)
      send_bytes(participant.routing_id, std::as_bytes(std::span(beat)));
}

void Hub::check_connect_deadline() {
  if (seconds_since(start_) < options_.deadlines.connect)
    return;
  std::string missing;
  std::string first;
  for (const auto& p : participants_)
    if (p.routing_id.empty()) {
      missing +=
          fmt::format("{}{} '{}'", missing.empty() ? "" : ", ", name(p.expected.role), p.expected.name);
      first = first.empty() ? p.expected.name : first;
    }
  fail(first, fmt::format("no HELLO from {} within {} s", missing, options_.deadlines.connect));
}

void Hub::check_domain_deadline() {
  const auto& p = domain();
  const double silence = seconds_since(p.last_heard);
  if (p.left || silence < options_.deadlines.step)
    return;
  fail(p.expected.name,
       fmt::format("no sign of life from domain '{}' for {:.1f} s (deadline {} s); the last was stage "
                   "'{}', step {}, {} s",
                   p.expected.name, silence, options_.deadlines.step, progress_.stage, progress_.step,
                   progress_.time));
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
  const std::string text = to_text({"REFUSE", {{"reason", reason}}});
  send_bytes(routing_id, std::as_bytes(std::span(text)));
}

void Hub::fail(const std::string& participant, const std::string& text) {
  if (!failure_)
    failure_ = Failure{participant, text};
}

void Hub::send(const Participant& participant, const Message& message) {
  const std::string text = to_text(message);
  forward(participant, std::as_bytes(std::span(text)));
}

void Hub::forward(const Participant& participant, std::span<const std::byte> bytes) {
  if (!send_bytes(participant.routing_id, bytes))
    fail(participant.expected.name, fmt::format("{} '{}' takes no messages", name(participant.expected.role),
                                                participant.expected.name));
}

bool Hub::send_bytes(const std::string& routing_id, std::span<const std::byte> bytes) {
  try {
    return socket_.send(zmq::const_buffer(routing_id.data(), routing_id.size()),
                        zmq::send_flags::sndmore | zmq::send_flags::dontwait) &&
           socket_.send(zmq::const_buffer(bytes.data(), bytes.size()), zmq::send_flags::dontwait);
  } catch (const zmq::error_t& error) {
    // It is gone: its BYE is on its way, or its process's end will be seen.
    if (error.num() == EHOSTUNREACH)
      return true;
    throw;
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
