#pragma once

// Command-line options for starting and connecting a run's processes, shared by `run` and `resume`.

#include "app/command_line.hpp"
#include "app/run/hosts/domain_ranks.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

namespace tremolo::app {

/// Threads that a process may have; more are a slip of the finger.
inline constexpr int most_threads = 1024;

/// Number of hardware threads of the machine.
int machine_threads();

struct LocalOptions {
  std::string transport = "ipc";
  std::filesystem::path keys; ///< folder of CURVE keys; empty: none
  bool local = false;         ///< whatever [hosts] says
  std::optional<int> threads; ///< of the domain, or of each of its ranks
  DomainRanks ranks;

  /// Without --threads the domain has those of the machine, which its ranks here share.
  int threads_of_domain(const scene::Case& scene) const {
    return threads.value_or(std::max(1, machine_threads() / ranks_here(scene, ranks, local)));
  }
};

/// @param options  outlives the command
void add_local_options(Command& command, LocalOptions& options);

} // namespace tremolo::app
