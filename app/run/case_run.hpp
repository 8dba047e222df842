#pragma once

// One run of a case: its text is written into the run's folder, so that the folder says what was computed;
// then the processes of its plan are started and watched to their end.

#include "app/run/hosts/domain_ranks.hpp"
#include "coupler/launch/launcher.hpp"
#include "scene/case.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

struct CaseRun {
  std::filesystem::path folder;    ///< empty, or not there yet
  std::optional<std::string> mode; ///< of the exchange, instead of the case's
  std::string transport = "ipc";   ///< or "tcp" on the loopback interface
  int threads = 1;                 ///< of the domain, or of each of its ranks
  std::filesystem::path keys{};    ///< folder of CURVE keys; empty: none
  bool local = false;              ///< all processes on this machine, whatever [hosts] says
  DomainRanks ranks{};
  std::string until{}; ///< name of the stage that it ends after; empty: the last one
  std::optional<coupler::CheckpointSet> resume{}; ///< goes on from there, in a folder that has it
};

/// The properties of a case on which the checkpoints of its run depend.
coupler::RunIdentity identity_of(const scene::Case& scene, const std::optional<std::string>& mode);

/// Whether the run in a folder has written all its results.
bool has_all_results(const std::filesystem::path& folder);

/// Runs a case in its folder.
/// @param scene  its relative file names have been made absolute (scene/read/override.hpp)
/// @returns what each process took
/// @throws Exit where a participant failed; it has been said
std::vector<coupler::ProcessSummary> run_case(scene::Case scene, const CaseRun& run);

} // namespace tremolo::app
