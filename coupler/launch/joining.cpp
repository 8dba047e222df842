#include "coupler/launch/joining.hpp"

#include "base/text/printable.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/frame.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "coupler/wire/sockets.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <span>
#include <tuple>

namespace tremolo::coupler {

namespace {

constexpr const char* monitor_address = "inproc://line";
constexpr double patience_s = 0.1; // between two looks at the line

zmq::socket_t connected(zmq::context_t& context, const JoinOptions& options) {
  try {
    return connected_dealer(context, options.endpoint, read_keys(options.keys, options.name));
  } catch (const zmq::error_t& error) {
    throw Error(fmt::format("cannot connect to '{}': {}", options.endpoint, error.what()));
  }
}

/// Meaning of an event of ZeroMQ's monitor for a waiting user; empty if it has none.
std::string meaning(std::uint16_t event, std::int32_t value, const std::string& name) {
  switch (event) {
  case ZMQ_EVENT_HANDSHAKE_FAILED_AUTH:
    return fmt::format("the hub does not know this key (status {}): {}.public must lie in the folder of keys "
                       "there, and [hosts] place '{}' elsewhere",
                       value, name, name);
  case ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL:
  case ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL:
    return "the keys do not fit: is hub.public here that of the hub?";
  case ZMQ_EVENT_CONNECT_RETRIED:
    return "nobody listens there: has the run begun, is the port open in the firewall?";
  default:
    return {};
  }
}

} // namespace

Joining::Joining(const JoinOptions& options)
    : options_(options), context_(new_context(2)), socket_(connected(context_, options)),
      monitor_(context_, zmq::socket_type::pair) {
  zmq_socket_monitor(socket_.handle(), monitor_address, ZMQ_EVENT_ALL);
  monitor_.connect(monitor_address);
}

void Joining::look_at_line() {
  for (zmq::message_t event; monitor_.recv(event, zmq::recv_flags::dontwait);) {
    std::uint16_t number = 0;
    std::int32_t value = 0;
    std::memcpy(&number, event.data(), sizeof number);
    std::memcpy(&value, static_cast<const char*>(event.data()) + sizeof number, sizeof value);
    zmq::message_t address;
    std::ignore = monitor_.recv(address, zmq::recv_flags::dontwait);
    gone_ = gone_ || number == ZMQ_EVENT_DISCONNECTED;
    const auto text = meaning(number, value, options_.name);
    // Another attempt follows every failure, and says less than that did.
    if (!text.empty() && (trouble_.empty() || number != ZMQ_EVENT_CONNECT_RETRIED))
      trouble_ = text;
  }
}

Invitation Joining::invitation() {
  nlohmann::json body{{"protocol", protocol_version}, {"name", options_.name}, {"build", TREMOLO_VERSION}};
  if (!options_.run.empty())
    body["run"] = options_.run;
  if (options_.case_text)
    body["case_text"] = *options_.case_text;
  const std::string join = to_text({"JOIN", std::move(body)});
  const auto start = Clock::now();
  bool asked = false;
  socket_.set(zmq::sockopt::sndtimeo, static_cast<int>(1000.0 * patience_s));
  while (seconds_since(start) < options_.deadline) {
    look_at_line();
    asked = asked || socket_.send(zmq::const_buffer(join.data(), join.size())).has_value();
    zmq::message_t raw;
    if (!asked || !wait_readable(socket_, patience_s) || !socket_.recv(raw, zmq::recv_flags::dontwait))
      continue;
    const Message answer =
        parse_message(std::span<const std::byte>(static_cast<const std::byte*>(raw.data()), raw.size()));
    if (answer.type == "REFUSE")
      throw Error(fmt::format("refused by the hub at {}: {}", options_.endpoint,
                              printable(text_or(answer.body, "reason", "no reason given"))));
    if (answer.type != "INVITE")
      throw Error(fmt::format("the hub at {} answered {} to JOIN", options_.endpoint, answer.type));
    look_at_line();
    gone_ = false; // attempts before this connection do not count
    return invitation_from(answer.body);
  }
  throw Error(fmt::format("'{}' waited {:.1f} s for an answer of the hub at {} (deadline {} s){}{}",
                          options_.name, seconds_since(start), options_.endpoint, options_.deadline,
                          trouble_.empty() ? "" : "; ", trouble_));
}

bool Joining::hub_is_gone() {
  look_at_line();
  return gone_;
}

void Joining::abandon(const std::string& reason) {
  const std::string text = to_text({"ABORT", {{"reason", reason}}});
  socket_.send(zmq::const_buffer(text.data(), text.size()), zmq::send_flags::dontwait); // never another wait
}

} // namespace tremolo::coupler
