#pragma once

// State of a running or finished run, as the hub knows it.

#include "coupler/client/timeline.hpp"
#include "coupler/mapping/timing.hpp"
#include "coupler/wire/error.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::coupler {

/// Why the run cannot go on.
struct Failure {
  std::string participant; ///< the one it is about; empty if none
  std::string text;
  bool refuses_checkpoint = false; ///< the one that the run was to go on from
};

/// A message that ends the run, with the whole of its reason.
class Fault : public Error {
public:
  explicit Fault(Failure failure) : Error(failure.text), failure_(std::move(failure)) {}
  [[nodiscard]] const Failure& failure() const { return failure_; }

private:
  Failure failure_;
};

/// Progress of the domain.
struct Progress {
  std::string stage = "start";
  std::uint64_t step = 0;
  double time = 0.0;                             ///< simulated, s
  double end_time = 0.0;                         ///< s
  std::optional<double> residual = std::nullopt; ///< of a stage that relaxes, 1
  friend bool operator==(const Progress&, const Progress&) = default;
};

/// A participant's final report on itself.
struct ParticipantReport {
  std::vector<PassTime> passes;
  double waiting = 0.0;          ///< for the exchange, s
  double particle_updates = 0.0; ///< the domain's; 0 otherwise
  TimelineReport timeline;       ///< empty of a participant that keeps none
};

} // namespace tremolo::coupler
