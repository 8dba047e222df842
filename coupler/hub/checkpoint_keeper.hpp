#pragma once

// The hub's part in checkpoints. The domain has saved itself at a step and says CHECKPOINT; the hub adds the
// progress of each source and the last data that it sent, and makes the set valid. A source is a function of
// the case: in a run that is resumed it computes and sends all its steps again, and the hub holds it to the
// bits of that last one.

#include "coupler/hub/admission/roster.hpp"
#include "coupler/hub/checkpoint_set.hpp"
#include "coupler/hub/hub_options.hpp"
#include "coupler/wire/frame.hpp"

#include <cstdint>
#include <vector>

namespace tremolo::coupler {

class CheckpointKeeper {
public:
  /// @param options,roster outlive it
  CheckpointKeeper(const HubOptions& options, const Roster& roster);

  /// Called when a source joins: in a resumed run, reads the data that it had sent at the checkpoint.
  /// @throws Fault for a file that is damaged or of another run
  void restore(const Participant& source);

  /// @param frame of the source, which follows the last one
  /// @throws Fault where a source does not compute the bits again that it sent before the checkpoint
  void remember(const Participant& source, std::uint32_t field, const Frame& frame);

  /// Completes the set of a step.
  /// @param time of the step, s
  /// @throws std::runtime_error where the disk does not take it
  void complete(std::uint64_t step, double time) const;

private:
  /// Progress of a field, and all values of its last step.
  struct Sent {
    std::uint64_t steps = 0;
    std::vector<double> last{};
  };
  struct FieldState {
    Sent now{};
    Sent at_checkpoint{}; ///< that the run was resumed from
  };

  void save(const Participant& source, const CheckpointSet& set) const;

  const HubOptions& options_;
  const Roster& roster_;
  std::vector<std::vector<FieldState>> fields_; ///< of each participant
};

} // namespace tremolo::coupler
