#pragma once

// The domain's side of the exchange:
//
//     DomainClient client(options);                          // early: a mismatch is found before any work
//     client.progress("gravity", step, time, end_time);      // a sign of life now and then
//     client.ready(faces, start_time, end_time);             // when the domain is at rest
//     for (each step)
//       client.tractions(step, time, face_velocities, face_tractions);
//     client.finish(pass_times);
//
// Whether Eq. (6) is evaluated here (mode window) or in the hub (mode lockstep) makes no difference to the
// caller, nor to a single bit of the tractions: both use BoundaryExchange.

#include "coupler/boundary_exchange.hpp"
#include "coupler/connection.hpp"
#include "coupler/field.hpp"
#include "coupler/mode.hpp"
#include "coupler/participant_options.hpp"
#include "coupler/timing.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::coupler {

class DomainClient {
public:
  /// Connects and waits until all participants are there.
  /// @throws Error if the hub refuses or a deadline passes
  explicit DomainClient(const ParticipantOptions& options);

  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] const std::vector<SourceDescription>& sources() const { return sources_; }

  /// Declares the boundary and the time it will be shaken (s, on the sources' clock).
  /// @throws Error if a source does not exist or does not cover a face's elevation or the time
  void ready(const std::vector<BoundaryFace>& faces, double start_time, double end_time);

  /// Eq. (6) for all faces at one time.
  /// @param step 0, 1, 2, ... since ready(); the time between steps may vary
  /// @param time s, not before the one of the previous step
  /// @param v_domain the domain's velocity at each face, m/s
  /// @param tractions out, Pa
  /// @throws Aborted when the run was ended by another; Error if a source does not deliver within the step
  /// deadline,
  ///         or a velocity is not finite
  void tractions(std::uint64_t step, double time, std::span<const eq6::Vector> v_domain,
                 std::span<eq6::Vector> tractions);

  /// The free field at each face in the last call of tractions(), for the energy ledger and the output.
  [[nodiscard]] std::span<const eq6::FreeField> free_field() const { return free_field_; }

  /// A sign of life for the progress line and the deadlines, also of stages that exchange nothing; cheap, may
  /// be called every step (sent a few times a second at most). Notices an abort.
  /// @throws Aborted when the run was ended by another
  void progress(const std::string& stage, std::uint64_t step, double time, double end_time);

  /// Tells the hub why this participant gives up: its log may lie on the disk that is full.
  void abandon(const std::string& reason) { connection_.abandon(reason); }

  /// Ends the run well. Call it when all results are written.
  /// @param passes named times of the domain's passes, s, for the summary
  /// @param particle_updates particles times steps, for the summary
  void finish(const std::vector<PassTime>& passes, double particle_updates);

  /// Time spent waiting for the exchange so far, s.
  [[nodiscard]] double waiting_seconds() const { return waiting_.seconds(); }

private:
  void wait_for_sources(std::uint64_t step, double time);
  void wait_for_hub(std::uint64_t step, std::span<eq6::Vector> tractions);
  void check_step(std::uint64_t step, double time, std::span<const eq6::Vector> v_domain);
  void append_velocities(double time, std::span<const eq6::Vector> v_domain);
  void send_velocities();
  void take_tractions(std::uint64_t step, std::span<const std::byte> bytes, std::span<eq6::Vector> tractions);
  void take_source_frame(std::span<const std::byte> bytes);
  void grant_credits();
  void beat(const std::optional<BoundaryExchange::Missing>& awaited);
  void check_hub(const std::string& awaited);
  void drain();

  ParticipantOptions options_;
  Connection connection_;
  Mode mode_ = Mode::window;
  std::uint32_t window_steps_ = default_window_steps;
  std::vector<SourceDescription> sources_;
  std::optional<BoundaryExchange> exchange_;
  std::size_t face_count_ = 0;
  std::vector<eq6::FreeField> free_field_;
  std::vector<double> batch_; ///< steps of [time, vx, vy of each face] not yet sent
  std::uint64_t batch_first_step_ = 0;
  std::uint64_t next_step_ = 0;
  double last_time_ = 0.0;
  std::string stage_ = "start";
  std::uint64_t stage_step_ = 0;
  double stage_time_ = 0.0;
  double stage_end_time_ = 0.0;
  Clock::time_point last_beat_;
  Stopwatch waiting_;
};

} // namespace tremolo::coupler
