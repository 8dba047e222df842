#pragma once

// The coupler's interface for participants of a run: their options (ParticipantOptions, and participant_main,
// which reads them), the exchanged data (field.hpp), and their side of the exchange, one class for either
// role. tremolo's own processes use nothing else.
//
// A source, which serves free fields:                  The domain, which takes them:
//
//     SourceClient client(options, {field});               DomainClient client(options);
//     client.serve([&](std::size_t field,                  client.progress("gravity", step, time, end_time);
//                      std::uint64_t step,                 client.ready(faces, start_time, end_time);
//                      std::span<double> values) {         for (each step)
//       ...fill values...                                    client.exchange(step, time, velocities);
//     });                                                  client.finish(pass_times, particle_updates);
//
// All methods of a client are called from one thread. After an exception the client is good for nothing but
// abandon(); the run has ended or will end.

#include "coupler/client/participant_options.hpp"
#include "coupler/client/timeline.hpp"
#include "coupler/mapping/face_exchange.hpp"
#include "coupler/mapping/timing.hpp"
#include "coupler/wire/connection.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/field.hpp"
#include "coupler/wire/mode.hpp"
#include "results/checkpoint_file.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::coupler {

/// A source's side of the exchange. It runs ahead of the domain as far as the receiver's credit goes and
/// sends several steps in a frame, so the domain seldom waits.
class SourceClient {
public:
  /// Connects, introduces itself with the fields it serves, and waits until all participants are there. A
  /// source that needs long to prepare does so after this call, so that a mismatch is found first.
  /// @pre every field passes validate(); field f of serve() is fields[f]
  /// @post all participants of the run are connected, have read the same case and know the fields
  /// @throws std::invalid_argument for a field that cannot be served; Error if the hub refuses or the connect
  /// deadline passes
  SourceClient(const ParticipantOptions& options, std::vector<FieldDescription> fields);

  /// Fills one step of one field: values[10 * point + k] in the order of values_per_point, all of them and
  /// all finite.
  using Fill = std::function<void(std::size_t field, std::uint64_t step, std::span<double> values)>;

  /// Serves steps until the domain has finished.
  /// @pre called once
  /// @post every step that the domain asked for has been filled once, the steps of a field in ascending order
  /// from 0; the hub knows the times of the passes; the process may end
  /// @param passes named times of what was done before (s), shown in the run's summary beside "fill" and
  /// "wait"
  /// @throws Aborted when the run was ended by another's failure; Error if the hub is silent beyond its
  /// deadline or a value is not finite; whatever fill throws
  void serve(const Fill& fill, const std::vector<PassTime>& passes = {});

  /// A sign of life from the solver's thread; needed only where more than the step deadline passes before the
  /// first step or between two.
  /// @pre done is finite
  /// @param done how much of the work is done, in any unit
  /// @post the step deadline begins anew if done is more than in any beat before: a solver that runs in
  /// circles ends the run
  /// @throws Error if the hub does not take it within the step deadline
  void beat(double done);

private:
  struct Outgoing {
    std::uint64_t next_step = 0;
    std::uint64_t credit = 0; ///< steps below this one may be sent
  };

  void take_messages(double wait_s);
  bool send_frames(const Fill& fill);
  void send_frame(std::size_t field, std::uint32_t steps, const Fill& fill);
  void say_bye(const std::vector<PassTime>& passes);

  ParticipantOptions options_;
  std::vector<FieldDescription> fields_;
  Connection connection_;
  std::vector<Outgoing> outgoing_;
  Stopwatch filling_;
  Stopwatch waiting_;
  Timeline timeline_; ///< from WELCOME on
  bool finished_ = false;
};

/// The domain's side of the exchange. Whether free fields are mapped to faces here (mode window) or in the
/// hub (mode lockstep) makes no difference to the caller, nor to a single bit: both use FaceExchange.
class DomainClient {
public:
  /// Connects and waits until all participants are there. To be made early: a mismatch is found before any
  /// work.
  /// @post all participants of the run are connected and have read the same case
  /// @throws Error if the hub refuses or the connect deadline passes
  explicit DomainClient(const ParticipantOptions& options);

  /// The step with which a resumed run continues.
  struct FirstStep {
    std::uint64_t step = 0;
    double time = 0.0; ///< s
  };

  /// Declares the boundary and the time it will be shaken (s, on the sources' clock).
  /// @pre called once, before the first exchange(); first as in the checkpoint that the run is resumed from
  /// @post the sources compute ahead
  /// @throws Error if a source does not exist or does not cover a face's elevation or the time
  void ready(const std::vector<ExchangedFace>& faces, double start_time, double end_time,
             const std::optional<FirstStep>& first = {});

  /// Data received in a step.
  struct Exchanged {
    std::span<const eq6::FreeField> free_field; ///< at each face; until the next step
    double waiting_seconds = 0.0;               ///< wall time spent waiting for the exchange so far
  };

  /// The free field at all faces at one time. In mode lockstep it comes with Eq. (6) as the hub evaluates it.
  /// @pre ready() was called; step is 0, or the first one, and one more every time; start_time <= time <=
  /// end_time of ready(); time is not before that of the last step; the span is as long as the list of faces
  /// @param v_domain the domain's velocity at each face, m/s
  /// @post the result has what Eq. (6) takes of this time at each face
  /// @throws Aborted when the run was ended by another; Error if a source does not deliver within the step
  /// deadline, a velocity is not finite, or the hub's tractions are not those of Eq. (6) here to the last
  /// bit; std::logic_error where the precondition on steps and lengths does not hold
  Exchanged exchange(std::uint64_t step, double time, std::span<const eq6::Vector> v_domain);

  /// Writes what the domain would go on from.
  using Save = std::function<void(results::CheckpointWriter& file)>;

  /// Makes the run one that can be resumed from here, by a domain that is given saved_state().
  /// @pre ready() was called, and not between exchange() and the end of its step; the run has a folder
  /// @param time of the next step, s
  /// @post the domain's state is on the disk, and the hub has let the set count or has said why it cannot
  /// @throws std::runtime_error where the disk does not take it; whatever save throws
  void checkpoint(double time, const Save& save);

  /// A sign of life for the progress line and the deadlines, also of stages that exchange nothing; cheap, may
  /// be called every step.
  /// @pre step and time do not go back within a stage
  /// @post the hub knows stage, step and time, and an abort was noticed; within 0.2 s of the last sign of
  /// life nothing is done
  /// @throws Aborted when the run was ended by another
  /// @param residual  of a stage that relaxes: what is left of the unbalanced force, 1
  void progress(const std::string& stage, std::uint64_t step, double time, double end_time,
                std::optional<double> residual = std::nullopt);

  /// Reports to the hub why this participant gives up: its log may lie on the disk that is full.
  /// @pre none: also after an exception
  /// @post the hub, if it listens, ends the run with this reason; no wait
  void abandon(const std::string& reason) { connection_.abandon(reason); }

  /// Ends the run well.
  /// @pre all results are written
  /// @param passes named times of the domain's passes, s, for the summary
  /// @param particle_updates particles times steps, for the summary
  /// @post the hub has answered, or the shutdown deadline has passed; it dismisses the sources; the process
  /// may end
  void finish(const std::vector<PassTime>& passes, double particle_updates);

private:
  void wait_for_sources(std::uint64_t step, double time);
  void wait_for_hub(std::uint64_t step, std::span<const eq6::Vector> v_domain);
  void check_step(std::uint64_t step, double time, std::span<const eq6::Vector> v_domain);
  void append_velocities(double time, std::span<const eq6::Vector> v_domain);
  void send_velocities();
  void take_tractions(std::uint64_t step, std::span<const std::byte> bytes,
                      std::span<const eq6::Vector> v_domain);
  void take_source_frame(std::span<const std::byte> bytes);
  void grant_credits();
  void beat(const std::optional<FaceExchange::Missing>& awaited);
  std::optional<Incoming> await(const std::string& whom);
  void check_hub(const std::string& awaited);
  void drain();

  ParticipantOptions options_;
  Connection connection_;
  Mode mode_ = Mode::window;
  std::vector<SourceDescription> sources_;
  std::optional<FaceExchange> exchange_;
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
  std::optional<double> stage_residual_;
  Clock::time_point last_beat_;
  Stopwatch waiting_;
  Timeline timeline_; ///< from WELCOME on
};

/// The state that DomainClient::checkpoint() saved, in a resumed run; null in a new one.
/// @throws std::runtime_error with both values for the file of another case or schema; or damaged
std::unique_ptr<results::CheckpointReader> saved_state(const ParticipantOptions& options);

} // namespace tremolo::coupler
