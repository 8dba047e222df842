#pragma once

// The run's data for its hub.

#include "coupler/client/participant_options.hpp"
#include "coupler/hub/checkpoint_set.hpp"
#include "coupler/hub/exchange_observer.hpp"
#include "coupler/launch/invitation.hpp"
#include "coupler/wire/field.hpp"
#include "coupler/wire/mode.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::coupler {

enum class Role { source, domain };

std::string_view name(Role role);

struct ExpectedParticipant {
  std::string name;
  Role role = Role::source;
  bool elsewhere = false; ///< it comes from another machine, by JOIN
};

/// Folder of a run's checkpoints.
struct CheckpointOptions {
  std::filesystem::path folder{};              ///< RUN/checkpoints; empty: none are made
  std::size_t keep = 0;                        ///< the newest ones
  std::map<std::string, std::string> inputs{}; ///< see RunIdentity
};

struct HubOptions {
  std::uint64_t session = 0; ///< random and secret: it stands in every frame of the run
  Mode mode = Mode::window;
  std::uint32_t window_steps = default_window_steps;
  std::string case_text;                         ///< of the file that all must have read
  std::vector<ExpectedParticipant> participants; ///< one domain and its sources
  Deadlines deadlines;
  std::filesystem::path keys{};                 ///< folder of CURVE keys; empty: a local endpoint only
  std::function<void(const std::string&)> note; ///< called with what was refused without ending the run
  ExchangeObserver* observer = nullptr;         ///< none, or one that outlives the hub
  std::string outer_endpoint{};  ///< for those from elsewhere, who alone use the keys; or empty
  std::string run_number{};      ///< random, no secret: JOIN of another run has another one
  std::vector<DataFile> files{}; ///< what they must have too
  CheckpointOptions checkpoints{};
  /// the checkpoint from which the run continues; none: it starts from the beginning
  std::optional<CheckpointSet> resume{};
};

} // namespace tremolo::coupler
