#pragma once

// The way of a process on another machine into a run: asks the hub for the invitation, then stays on the line
// while the participant computes, so that either side learns at once of the other's death.

#include "coupler/launch/invitation.hpp"
#include "coupler/mapping/timing.hpp"

#include <memory>
#include <optional>
#include <string>
#include <zmq.hpp>

namespace tremolo::coupler {

struct JoinOptions {
  std::string endpoint;
  std::string name;
  std::filesystem::path keys;             ///< folder of CURVE keys
  std::string run;                        ///< number of the run that is meant; empty: the one that is there
  std::optional<std::string> case_text{}; ///< the case that is meant, names of files absolute
  double deadline = 30.0;                 ///< for the invitation, s
};

class Joining {
public:
  /// @throws Error for keys that cannot be used, or an address that cannot be connected to
  explicit Joining(const JoinOptions& options);

  /// @throws Error if the hub refuses, or does not answer within the deadline: with what is known of why
  Invitation invitation();

  /// Whether the connection to the hub was lost after the invitation: its process has ended, or its machine
  /// has closed the connection. A line that is cut shows only in the deadlines.
  bool hub_is_gone();

  /// Reports to the hub that the participant will not go on, and why.
  void abandon(const std::string& reason);

private:
  void look_at_line();

  JoinOptions options_;
  zmq::context_t context_;
  zmq::socket_t socket_;
  zmq::socket_t monitor_;
  std::string trouble_; ///< the last that befell the connection
  bool gone_ = false;
};

} // namespace tremolo::coupler
