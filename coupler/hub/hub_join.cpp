// Who may become a participant from another machine: under its own name, with its own key, of this run and
// this case, and only where the run expects it from elsewhere.

#include "coupler/hub/case_difference.hpp"
#include "coupler/hub/hub.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/sockets.hpp"

#include <array>
#include <fmt/format.h>
#include <unistd.h>

namespace tremolo::coupler {

namespace {

/// An address that means all interfaces says nothing to another machine: this machine's name takes its place.
std::string as_told(const std::string& bound) {
  for (const std::string_view any : {"tcp://0.0.0.0:", "tcp://[::]:"})
    if (bound.starts_with(any)) {
      std::array<char, 256> name{};
      ::gethostname(name.data(), name.size() - 1);
      return fmt::format("tcp://{}:{}", name.data(), bound.substr(any.size()));
    }
  return bound;
}

} // namespace

void Hub::listen_to_others() {
  if (options_.keys.empty())
    throw Error(fmt::format("'{}' can be reached from other machines: it needs CURVE keys (--keys FOLDER; "
                            "`tremolo keygen` makes them)",
                            options_.outer_endpoint));
  try {
    bind_also(socket_, options_.outer_endpoint, read_keys(options_.keys, hub_key));
  } catch (const zmq::error_t& error) {
    throw Error(fmt::format("the hub cannot listen at '{}': {}", options_.outer_endpoint, error.what()));
  }
  outer_endpoint_ = as_told(socket_.get(zmq::sockopt::last_endpoint));
}

bool Hub::has_foreign_key(const std::string& routing_id, const nlohmann::json& claim, zmq::message_t& raw) {
  const auto claimed = claim.at("name").get<std::string>();
  const char* owner = zmq_msg_gets(raw.handle(), "User-Id"); // as ClientGate has told it; none over ipc
  if (owner == nullptr || *owner == '\0' || claimed == owner)
    return false;
  refuse(routing_id, fmt::format("'{}' came with the key of '{}'", claimed, owner));
  return true;
}

void Hub::take_join(const std::string& routing_id, const nlohmann::json& join, zmq::message_t& raw) {
  const auto wanted = join.at("name").get<std::string>();
  if (has_foreign_key(routing_id, join, raw))
    return;
  auto* participant = find_name(wanted);
  if (participant == nullptr)
    return refuse(routing_id, fmt::format("this run has no participant '{}'", wanted));
  if (!participant->expected.elsewhere)
    return refuse(routing_id, fmt::format("'{}' is started by the run itself: [hosts] does not place it "
                                          "elsewhere",
                                          wanted));
  if (!participant->routing_id.empty() ||
      (!participant->usher.empty() && send_to(participant->usher, {"BEAT"})))
    return refuse(routing_id,
                  fmt::format("'{}' is already taking part in this run; a second one was refused", wanted));
  if (const int version = join.at("protocol").get<int>(); version != protocol_version)
    return refuse(routing_id, fmt::format("'{}' (build {}) says protocol = {}, the hub (build {}) has {}",
                                          wanted, join.at("build").get<std::string>(), version,
                                          TREMOLO_VERSION, protocol_version));
  if (const auto session = join.value("session", session_text(options_.session));
      session != session_text(options_.session))
    return refuse(routing_id, fmt::format("'{}' belongs to session {}, this run is {}", wanted, session,
                                          session_text(options_.session)));
  if (const auto text = join.value("case_text", options_.case_text); text != options_.case_text)
    return refuse(routing_id, fmt::format("'{}' has another case: {}", wanted,
                                          case_difference(text, options_.case_text)));
  participant->usher = routing_id;
  send_to(routing_id, {"INVITE", to_json(Invitation{options_.session, options_.case_text, options_.files,
                                                    options_.deadlines})});
}

/// Where a participant of another machine ends, no child of this one does: the connection tells it.
void Hub::watch_line(Participant& participant, bool connected) {
  constexpr double patience_s = 1.0; // its last words, or those of who has started it, say more
  if (connected || !participant.expected.elsewhere)
    participant.line_lost.reset();
  else if (!participant.line_lost)
    participant.line_lost = Clock::now();
  else if (seconds_since(*participant.line_lost) > patience_s)
    fail(participant.expected.name,
         fmt::format("the connection to '{}' on another machine is gone: its process has ended, or something "
                     "between the machines has closed it",
                     participant.expected.name));
}

bool Hub::is_word_of_usher(const std::string& routing_id, const Message& message) {
  for (const auto& p : participants_)
    if (message.type == "ABORT" && p.usher == routing_id && !p.left) {
      fail(p.expected.name, message.body.value("reason", "no reason given"));
      return true;
    }
  return false;
}

} // namespace tremolo::coupler
