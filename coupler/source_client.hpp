#pragma once

// A source's side of the exchange. A source is a loop of one call:
//
//     SourceClient client(options, {field});
//     client.serve([&](std::size_t field, std::uint64_t step, std::span<double> values) { ...fill values...
//     });
//
// It runs ahead of the domain as far as the receiver's credit goes and sends several steps in a frame, so the
// domain seldom waits.

#include "coupler/connection.hpp"
#include "coupler/field.hpp"
#include "coupler/participant_options.hpp"
#include "coupler/timing.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tremolo::coupler {

class SourceClient {
public:
  /// Connects, introduces itself with the fields it serves, and waits until all participants are there. A
  /// source that needs long to prepare does so after this call, so that a mismatch is found first.
  /// @throws std::invalid_argument for a field that cannot be served; Error if the hub refuses or a deadline
  /// passes
  SourceClient(const ParticipantOptions& options, std::vector<FieldDescription> fields);

  /// Fills one step of one field: values[10 * point + k] in the order of values_per_point. The steps of a
  /// field are asked for once each, in ascending order from 0.
  using Fill = std::function<void(std::size_t field, std::uint64_t step, std::span<double> values)>;

  /// Serves steps until the domain has finished.
  /// @throws Aborted when the run was ended by another's failure; Error if the hub is silent beyond its
  /// deadline or
  ///         a value is not finite
  void serve(const Fill& fill);

  /// A sign of life from the solver's thread; needed only where more than the step deadline passes between
  /// two steps.
  /// @param done how much of the work is done, in any unit: only a beat that reports more than the last one
  /// prolongs the deadline, so that a solver that runs in circles ends the run
  void beat(double done);

  /// Named times of this participant's passes (s) that the run's summary shows beside "fill" and "wait".
  void report(std::vector<PassTime> passes) { passes_ = std::move(passes); }

private:
  struct Outgoing {
    std::uint64_t next_step = 0;
    std::uint64_t credit = 0; ///< steps below this one may be sent
    std::uint32_t steps_per_frame = 1;
  };

  void take_messages(double wait_s);
  bool send_frames(const Fill& fill);
  void send_frame(std::size_t field, std::uint32_t steps, const Fill& fill);
  void say_bye();

  ParticipantOptions options_;
  std::vector<FieldDescription> fields_;
  Connection connection_;
  std::vector<Outgoing> outgoing_;
  std::vector<double> body_;
  std::vector<PassTime> passes_;
  Stopwatch filling_;
  Stopwatch waiting_;
  bool finished_ = false;
};

} // namespace tremolo::coupler
