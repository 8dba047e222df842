#include "coupler/wire/connection.hpp"

#include "base/text/printable.hpp"
#include "base/text/text_file.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/incoming.hpp"
#include "coupler/wire/sockets.hpp"

#include <fmt/format.h>

namespace tremolo::coupler {

namespace {

/// The hub knows more than a participant does, so its verdict on a deadline should come first.
constexpr double grace_s = 1.0;

void free_values(void* values, void* /*hint*/) {
  delete[] static_cast<double*>(values);
}

} // namespace

Connection::Connection(const ParticipantOptions& options)
    : context_(std::make_unique<zmq::context_t>(new_context(1))), name_(options.name),
      case_text_(read_text_file(options.case_file)), session_(session_of(options)),
      deadlines_(options.deadlines), last_heard_(Clock::now()) {
  try {
    std::optional<CurveKeys> keys;
    if (!options.keys.empty())
      keys = read_keys(options.keys, options.name);
    socket_ = std::make_unique<zmq::socket_t>(connected_dealer(*context_, options.endpoint, keys));
  } catch (const zmq::error_t& error) {
    throw Error(fmt::format("cannot connect to the hub at '{}': {}", options.endpoint, error.what()));
  }
}

Connection::~Connection() = default;

Message Connection::introduce(Message hello) {
  hello.body["protocol"] = protocol_version;
  hello.body["session"] = session_text(session_);
  hello.body["name"] = name_;
  hello.body["build"] = TREMOLO_VERSION;
  hello.body["units"] = "SI";
  hello.body["case"] = text_crc(case_text_);
  hello.body["case_text"] = case_text_;
  const auto start = Clock::now();
  send_text(hello, deadlines_.connect);
  while (seconds_since(start) < deadlines_.connect + grace_s) {
    const auto incoming = receive(0.5);
    if (!incoming || !incoming->message || incoming->message->type != "WELCOME")
      continue;
    number_ = whole_32_at(incoming->message->body, "number");
    return *incoming->message;
  }
  throw Error(fmt::format("'{}' waited {:.1f} s for WELCOME from the hub (deadline {} s); {}", name_,
                          seconds_since(start), deadlines_.connect, sign_of_life()));
}

void Connection::send(const Message& message) {
  send_text(message, deadlines_.step);
}

void Connection::send(const FrameHeader& header, FrameDraft draft) {
  const auto bytes = draft.bytes();
  seal(header, bytes);
  zmq::message_t raw(draft.release(), bytes.size(), free_values);
  send_raw(raw, deadlines_.step);
}

void Connection::take_leave(const Message& bye) {
  send(bye);
  const auto start = Clock::now();
  while (seconds_since(start) < deadlines_.shutdown) {
    const auto incoming = receive(deadlines_.shutdown - seconds_since(start));
    if (incoming && incoming->message && incoming->message->type == "BYE")
      return;
  }
}

void Connection::send_text(const Message& message, double deadline_s) {
  const std::string text = to_text(message);
  zmq::message_t raw(text.data(), text.size());
  send_raw(raw, deadline_s);
}

void Connection::send_raw(zmq::message_t& raw, double deadline_s) {
  require_fits(raw.size());
  const auto start = Clock::now();
  // Set at each call because HELLO has another deadline than the rest.
  socket_->set(zmq::sockopt::sndtimeo, static_cast<int>(deadline_s * 1000.0));
  if (!socket_->send(raw, zmq::send_flags::none))
    throw Error(fmt::format("'{}' waited {:.1f} s for the hub to take a message (deadline {} s); {}", name_,
                            seconds_since(start), deadline_s, sign_of_life()));
}

std::optional<Incoming> Connection::receive(double wait_s) {
  Incoming incoming;
  // Asking first saves two calls of the system where nothing has come, or more has: so at every step.
  if (!socket_->recv(incoming.raw, zmq::recv_flags::dontwait) &&
      (wait_s <= 0.0 || !wait_readable(*socket_, wait_s) ||
       !socket_->recv(incoming.raw, zmq::recv_flags::dontwait)))
    return std::nullopt;
  last_heard_ = Clock::now();
  heard_ = true;
  if (!looks_like_message(incoming.frame()))
    return incoming;
  Message message = parse_message(incoming.frame());
  const std::string reason = printable(text_or(message.body, "reason", "no reason given"));
  if (message.type == "ABORT")
    throw Aborted("the run was ended: " + reason);
  if (message.type == "REFUSE")
    throw Error("refused by the hub: " + reason);
  incoming.message = std::move(message);
  return incoming;
}

bool Connection::hub_is_silent() const {
  return seconds_since(last_heard_) > deadlines_.step + grace_s;
}

std::string Connection::sign_of_life() const {
  return heard_ ? fmt::format("last sign of life of the hub {:.1f} s ago", seconds_since(last_heard_))
                : "no sign of life of the hub so far";
}

void Connection::abandon(const std::string& reason) {
  const std::string text = to_text({"ABORT", {{"reason", reason}}});
  socket_->send(zmq::const_buffer(text.data(), text.size()), zmq::send_flags::dontwait); // never another wait
}

void Connection::fail(const std::string& reason) {
  abandon(reason);
  throw Error(reason);
}

} // namespace tremolo::coupler
