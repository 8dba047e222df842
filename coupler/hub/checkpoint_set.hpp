#pragma once

// A set of files from which a run can go on, in a folder of its own, RUN/checkpoints/STEP: one file for every
// participant, and a manifest that names them with their sizes and checksums. A set that is being made lies
// in STEP.part; one rename makes it count, when all its files are on the disk. A set that has been damaged
// since is recognised before anything starts, and the run goes on from an older one.

#include "coupler/wire/mode.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::coupler {

/// Identity of a run, as far as a checkpoint depends on it.
struct RunIdentity {
  std::string case_text;
  std::map<std::string, std::string> inputs{}; ///< files that the case refers to, and the CRC-32 of each
  Mode mode = Mode::window;
  std::uint32_t window_steps = 0;
};

/// A complete set.
struct CheckpointSet {
  std::filesystem::path folder;
  std::uint64_t step = 0; ///< of the domain: the next one
  double time = 0.0;      ///< of that step, s
  RunIdentity run;
};

/// Folder of the set that is being made for a step.
/// @param checkpoints RUN/checkpoints
std::filesystem::path draft_folder(const std::filesystem::path& checkpoints, std::uint64_t step);

/// Writes the manifest into the set's folder, a draft, lets the set count, and removes all but the newest.
/// Sets of later steps go too: the run did not go on from them because they are damaged.
/// @throws std::runtime_error where the disk does not take it
void publish(const CheckpointSet& set, std::size_t keep);

/// Result of a search for the checkpoints from which a run can continue.
struct FoundSets {
  std::optional<CheckpointSet> newest; ///< of those that are whole
  std::vector<std::string> damaged;    ///< what is wrong with newer ones, the newest first
};

/// Looks for the newest set whose files all are what its manifest says. Folders that are not named by a step
/// are none of ours.
/// @param checkpoints RUN/checkpoints
/// @throws Error for a set that another version of schema or build made (with both)
FoundSets find_sets(const std::filesystem::path& checkpoints);

/// @throws Error with every difference, both values each, if the set belongs to another run
void require_same_run(const CheckpointSet& set, const RunIdentity& run);

} // namespace tremolo::coupler
