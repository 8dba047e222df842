#pragma once

// The hub: the one place where all participants meet. It is put together from parts with one task each: a
// roster of who takes part, the post that carries messages, admission, routing, the watch over deadlines and
// the keeper of checkpoints. Every message goes to the part that it is for, every tick asks the watch. The
// hub never blocks and never starts or stops a process (launcher.hpp does), so it can be tested on its own.
//
//     participant               hub
//       HELLO  ------------------>   checked against what the run expects; REFUSE otherwise
//             <------------------  WELCOME to all, once all are there
//       READY (domain) ---------->   faces checked against what sources serve
//             <------------------  CREDIT to sources
//       frames ------------------>   to the domain (window) or into Eq. (6) (lockstep)
//       CHECKPOINT (domain) ----->   a set of files is complete, the run can be resumed from it
//       BYE (domain) ------------>
//             <------------------  BYE to the domain at once, to sources when all they owe is there
//       BYE (sources) ----------->   finished

#include "coupler/hub/admission/admission.hpp"
#include "coupler/hub/admission/roster.hpp"
#include "coupler/hub/checkpoint_keeper.hpp"
#include "coupler/hub/hub_options.hpp"
#include "coupler/hub/notes.hpp"
#include "coupler/hub/post.hpp"
#include "coupler/hub/progress.hpp"
#include "coupler/hub/routing.hpp"
#include "coupler/hub/watch.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <zmq.hpp>

namespace tremolo::coupler {

class Hub {
public:
  /// @param endpoint "ipc:///..." or "tcp://127.0.0.1:*"
  /// @throws Error if it cannot be bound
  Hub(zmq::context_t& context, const std::string& endpoint, HubOptions options);
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  /// The address to give to participants: with the port that was found.
  [[nodiscard]] const std::string& endpoint() const { return post_.endpoint(); }

  /// Address at which participants on other machines reach the hub.
  [[nodiscard]] const std::string& outer_endpoint() const { return post_.outer_endpoint(); }

  /// The socket to poll.
  [[nodiscard]] zmq::socket_ref socket() { return post_.socket(); }

  /// Takes all messages that wait.
  void take_messages();

  /// Beats, and looks whether somebody has waited too long. Call it several times a second.
  void tick();

  /// Sends every participant word that the run is over, and why.
  void abort(const std::string& reason);

  /// The first failure, if any. The caller ends the run.
  [[nodiscard]] const std::optional<Failure>& failure() const { return failure_; }

  [[nodiscard]] bool finished() const;
  /// Whether a participant has said BYE: its process may end.
  [[nodiscard]] bool has_left(const std::string& participant) const;
  /// Whether the sources have been sent BYE: the run has all it needs of them.
  [[nodiscard]] bool has_dismissed_sources() const { return routing_.has_dismissed(); }
  [[nodiscard]] const Progress& progress() const { return watch_.progress(); }
  [[nodiscard]] const std::map<std::string, ParticipantReport>& reports() const { return reports_; }

private:
  void take(Letter& letter);
  void take_from(Participant& participant, Letter& letter);
  void take_from_stranger(Letter& letter);
  void take_message(Participant& participant, const Message& message);
  void take_hello(Letter& letter, const nlohmann::json& hello);
  void take_beat(Participant& participant, const nlohmann::json& body);
  void take_checkpoint(const nlohmann::json& body);
  void take_bye(Participant& participant, const nlohmann::json& body);
  void welcome_all();
  void refuse(const std::string& routing_id, const std::string& reason);
  void fail(const std::optional<Failure>& failure);

  const HubOptions options_;
  Notes notes_;
  Roster roster_;
  Post post_;
  Admission admission_;
  Watch watch_;
  CheckpointKeeper keeper_;
  Routing routing_;
  Clock::time_point last_beat_;
  bool welcomed_ = false;
  std::optional<Failure> failure_;
  std::map<std::string, ParticipantReport> reports_;
};

} // namespace tremolo::coupler
