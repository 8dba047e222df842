#pragma once

// What the command line says about how a run's processes are started and talk; `run` and `resume` share it.

#include "app/command_line.hpp"

#include <filesystem>
#include <string>

namespace tremolo::app {

/// Threads that a process may have; more are a slip of the finger.
inline constexpr int most_threads = 1024;

/// As many threads as the machine runs at once.
int machine_threads();

struct LocalOptions {
  std::string transport = "ipc";
  std::filesystem::path keys;      ///< folder of CURVE keys; empty: none
  bool local = false;              ///< whatever [hosts] says
  int threads = machine_threads(); ///< of the domain
};

/// @param options  outlives the command
void add_local_options(Command& command, LocalOptions& options);

} // namespace tremolo::app
