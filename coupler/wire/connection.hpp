#pragma once

// A participant's one connection to the hub: sends, receives within a deadline, and remembers when the hub
// last gave a sign of life.

#include "coupler/client/participant_options.hpp"
#include "coupler/mapping/timing.hpp"
#include "coupler/wire/frame.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace zmq {
class context_t;
class message_t;
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
  void send(const FrameHeader& header, FrameDraft draft);

  /// BYE, then waits for the hub's answer, at most for the shutdown deadline. A connection that is closed at
  /// once loses what a slow hub has not taken yet: linger counts messages that libzmq has begun to write as
  /// sent.
  /// @throws Error if the hub does not take it within the step deadline; Aborted when the run was ended
  void take_leave(const Message& bye);

  /// The next message: a control message or a data frame; nothing if none came within wait_s.
  /// @throws Aborted for ABORT and REFUSE
  std::optional<Incoming> receive(double wait_s);

  /// Reports to the hub, if it listens, why this participant leaves.
  void abandon(const std::string& reason);

  /// Abandons the connection and throws the reason.
  [[noreturn]] void fail(const std::string& reason);

  /// Whether the hub, which beats several times a second, has been silent for longer than the step deadline.
  [[nodiscard]] bool hub_is_silent() const;
  /// "last sign of life of the hub 3.1 s ago"
  [[nodiscard]] std::string sign_of_life() const;
  [[nodiscard]] std::uint32_t number() const { return number_; }
  [[nodiscard]] std::uint64_t session() const { return session_; }

private:
  void send_raw(zmq::message_t& raw, double deadline_s);
  void send_text(const Message& message, double deadline_s);

  std::unique_ptr<zmq::context_t> context_;
  std::unique_ptr<zmq::socket_t> socket_;
  std::string name_;
  std::string case_text_;
  std::uint64_t session_;
  Deadlines deadlines_;
  std::uint32_t number_ = 0;
  Clock::time_point last_heard_; ///< from the start where the hub has not spoken yet
  bool heard_ = false;
};

} // namespace tremolo::coupler
