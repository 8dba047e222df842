#pragma once

#include "coupler/launch/launcher.hpp"
#include "scene/case.hpp"

#include <filesystem>

namespace tremolo::app {

/// The ranks that share the domain of a run.
struct DomainRanks {
  int count = 1;
  bool oversubscribe = false; ///< whether there may be more than the machines have processors
};

/// Ranks of a run; more are a slip of the finger.
inline constexpr int most_ranks = 4096;

/// Refuses, before anything is started, ranks that cannot be started.
/// @param local  whether all run here, whatever [hosts.domain] says
/// @throws std::runtime_error, std::invalid_argument with the reason and what to do
void check_ranks(const scene::Case& scene, const DomainRanks& ranks, bool local);

/// Ranks on the machine of the run.
int ranks_here(const scene::Case& scene, const DomainRanks& ranks, bool local);

/// Who starts the ranks on which machines: "on this machine", "2 here, 4 on node2, through ssh".
std::string ranks_text(const scene::Case& scene, const DomainRanks& ranks, bool local);

/// Folder of the files through which ranks communicate: in memory, or the temporary folder.
std::filesystem::path shared_memory_parent();

/// Lets mpirun start the domain's process as several ranks.
/// @param folder  private one, for what they leave if they are killed
/// @param connect_deadline of the run, s
void start_as_ranks(coupler::ProcessSpec& domain, const scene::Case& scene, const DomainRanks& ranks,
                    bool local, const std::filesystem::path& folder, double connect_deadline);

} // namespace tremolo::app
