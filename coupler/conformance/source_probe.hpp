#pragma once

// One session with one source program, as the hub would hold it but for a test: the probe starts the program,
// speaks the hub's side of the protocol word by word, and leaves it to the caller to judge what comes back.

#include "coupler/client/participant_options.hpp"
#include "coupler/launch/child_process.hpp"
#include "coupler/launch/run_endpoint.hpp"
#include "coupler/mapping/timing.hpp"
#include "coupler/wire/field.hpp"
#include "coupler/wire/incoming.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>
#include <zmq.hpp>

namespace tremolo::coupler {

struct ProbeOptions {
  std::vector<std::string> command; ///< the program and its own arguments
  std::filesystem::path case_file;
  std::string name;             ///< of the source in the case
  std::filesystem::path folder; ///< exists; the program's log is written to it
  Deadlines deadlines;
};

class SourceProbe {
public:
  /// The source's number in the run, the sender of its frames.
  static constexpr std::uint32_t number = 1;

  /// Starts the program.
  /// @throws Error if it cannot be started
  explicit SourceProbe(const ProbeOptions& options);

  /// The HELLO as received.
  /// @throws Error if the program ends, or none has come within the connect deadline
  Message hello();

  void send(const Message& message);

  /// The next message or frame; nothing if none came within wait_s. Beats as a hub does.
  /// @throws Error if the program has ended
  std::optional<Incoming> receive(double wait_s);

  /// Falls silent for good, as a hub that was killed.
  void vanish();

  /// Waits until the process has ended, at most wait_s. Messages that come in are dropped.
  bool ends_within(double wait_s);

  [[nodiscard]] const ChildProcess& process() const { return process_; }
  [[nodiscard]] std::uint64_t session() const { return session_of(options_); }

  /// A text on the end of the process, with its last lines.
  [[nodiscard]] std::string last_words() const;

private:
  std::optional<Incoming> take();
  void beat();

  RunEndpoint endpoint_;
  zmq::context_t context_;
  zmq::socket_t socket_;
  ParticipantOptions options_;
  ChildProcess process_;
  std::string routing_id_;
  Clock::time_point last_beat_;
};

} // namespace tremolo::coupler
