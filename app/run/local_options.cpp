#include "app/run/local_options.hpp"

#include <algorithm>
#include <thread>

namespace tremolo::app {

LocalOptions::LocalOptions() : threads(static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))) {}

void add_local_options(CLI::App& command, LocalOptions& options) {
  command.add_option("--transport", options.transport, "ipc (default) or tcp on the loopback interface")
      ->check(CLI::IsMember({"ipc", "tcp"}));
  command
      .add_option("--keys", options.keys,
                  "Folder of CURVE keys (`tremolo keygen`): the exchange is encrypted, and only their "
                  "owners take part")
      ->check(CLI::ExistingDirectory);
  command.add_flag("--local", options.local,
                   "All processes on this machine, whatever the [hosts] of the case say");
  command.add_option("--threads", options.threads, "Threads of the domain; results do not depend on it")
      ->check(CLI::Range(1, most_threads))
      ->capture_default_str();
}

} // namespace tremolo::app
