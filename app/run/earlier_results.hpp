#pragma once

#include "coupler/hub/checkpoint_set.hpp"

#include <filesystem>
#include <optional>

namespace tremolo::app {

/// Reads what a resumed run takes over from run.h5, and compares it with the checksums of its checkpoint.
/// @param set  none: only whether the run is complete
/// @returns whether the run is complete, so that there is nothing to go on with
/// @throws std::runtime_error where the file is missing or damaged, with the dataset and what to do
bool earlier_results_are_complete(const std::filesystem::path& folder,
                                  const std::optional<coupler::CheckpointSet>& set);

} // namespace tremolo::app
