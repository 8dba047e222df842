#pragma once

// The hub's part in checkpoints. The domain has saved itself at a step and says CHECKPOINT; the hub adds how
// far each source has come and what it sent last, and lets the set count. A source is a function of the case:
// in a run that is resumed it computes and sends all its steps again, and the hub holds it to the bits of
// that last one.

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

  /// A source has come: reads what it had sent at the checkpoint that the run is resumed from, if it is.
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
