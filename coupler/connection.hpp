#pragma once

// A participant's one connection to the hub: sends, receives within a deadline, and remembers when the hub
// last gave a sign of life.

#include "coupler/frame.hpp"
#include "coupler/participant_options.hpp"
#include "coupler/timing.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace zmq {
class context_t;
class socket_t;
} // namespace zmq

namespace tremolo::coupler {

struct Message;
struct Incoming;

class Connection {
public:
  explicit Connection(const ParticipantOptions& options);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// HELLO, then waits for WELCOME.
  /// @throws Error if the hub refuses or the connect deadline passes
  Message introduce(Message hello);

  /// @throws Error if the hub does not take it within the step deadline
  void send(const Message& message);
  void send(const FrameHeader& header, std::span<const double> values);

  /// The next message: a control message or the bytes of a data frame; nothing if none came within wait_s.
  /// @throws Aborted for ABORT and REFUSE
  std::optional<Incoming> receive(double wait_s);

  /// Tells the hub why this participant leaves, and throws it.
  [[noreturn]] void fail(const std::string& reason);

  /// Whether the hub, which beats several times a second, has been silent for longer than the step deadline.
  [[nodiscard]] bool hub_is_silent() const;
  [[nodiscard]] double seconds_since_sign_of_life() const { return seconds_since(last_heard_); }
  [[nodiscard]] std::uint32_t number() const { return number_; }
  [[nodiscard]] std::uint64_t session() const { return session_; }

private:
  void send_bytes(std::span<const std::byte> bytes, double deadline_s);

  std::unique_ptr<zmq::context_t> context_;
  std::unique_ptr<zmq::socket_t> socket_;
  std::string name_;
  std::uint64_t session_;
  Deadlines deadlines_;
  std::uint32_t number_ = 0;
  Clock::time_point last_heard_;
};

} // namespace tremolo::coupler
