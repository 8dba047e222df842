#pragma once

// Routing of messages once all participants are present: READY, credit, the sources' frames, the domain's
// velocities. In mode window frames go on to the domain as they came; in mode lockstep Eq. (6) is evaluated
// here and tractions go back. An observer (exchange_observer.hpp) receives every frame.

#include "coupler/hub/admission/roster.hpp"
#include "coupler/hub/checkpoint_keeper.hpp"
#include "coupler/hub/hub_options.hpp"
#include "coupler/hub/post.hpp"
#include "coupler/hub/watch.hpp"
#include "coupler/mapping/face_exchange.hpp"

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::coupler {

class Routing {
public:
  /// @param options,roster,post,watch,keeper outlive it
  Routing(const HubOptions& options, Roster& roster, Post& post, Watch& watch, CheckpointKeeper& keeper)
      : options_(options), roster_(roster), post_(post), watch_(watch), keeper_(keeper),
        outlets_(roster.all().size()) {}

  /// @throws Fault where the faces do not fit what the sources serve; Error for nonsense, as all of these
  void take_ready(const nlohmann::json& body);
  void take_credit(const nlohmann::json& body);
  void take_source_frame(const Participant& source, zmq::message_t& raw);
  void take_velocities(const Participant& domain, std::span<const std::byte> bytes);
  /// Reads from the domain's beat what it waits for.
  void take_wait(const nlohmann::json& body);
  /// The domain has said BYE: sources are asked for what is still needed, then dismissed.
  void end();

  [[nodiscard]] bool is_ready() const { return ready_; }
  [[nodiscard]] bool has_dismissed() const { return dismissed_; }
  /// The step whose velocities come next.
  [[nodiscard]] std::uint64_t next_domain_step() const { return next_domain_step_; }
  /// Data that the domain has still to send.
  [[nodiscard]] std::string owed_by_domain() const;

private:
  /// Progress of a source's field, and its credit.
  struct Outlet {
    std::uint64_t next_step = 0;
    std::uint64_t credit = 0;
    std::uint64_t needed = 0; ///< until the end, where somebody looks on
  };
  /// A step of the domain in mode lockstep that still lacks source steps.
  struct PendingStep {
    std::uint64_t step = 0;
    double time = 0.0;
    std::vector<eq6::Vector> v_domain;
  };

  std::vector<Outlet>& of(const Participant& source);
  void begin_observation(const FaceExchange& exchange, double start_time, double end_time);
  void observe(std::span<const std::byte> bytes);
  void grant_new_credits();
  void grant(const Participant& source, std::uint32_t field, std::uint64_t steps);
  bool owes_a_frame(const Participant& source);
  void answer_pending_step();
  void dismiss_sources();

  const HubOptions& options_;
  Roster& roster_;
  Post& post_;
  Watch& watch_;
  CheckpointKeeper& keeper_;
  std::vector<std::vector<Outlet>> outlets_; ///< of each participant
  bool ready_ = false;
  bool dismissed_ = false; ///< the sources have been sent BYE
  std::size_t face_count_ = 0;
  std::uint64_t next_domain_step_ = 0;
  std::optional<FaceExchange> exchange_; ///< mode lockstep
  std::optional<PendingStep> pending_;   ///< mode lockstep
};

} // namespace tremolo::coupler
