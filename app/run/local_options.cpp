#include "app/run/local_options.hpp"

#include <algorithm>
#include <thread>

namespace tremolo::app {

int machine_threads() {
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

void add_local_options(Command& command, LocalOptions& options) {
  command.add_option("--transport", options.transport, "ipc (default) or tcp on the loopback interface")
      ->one_of({"ipc", "tcp"});
  command
      .add_option("--keys", options.keys,
                  "Folder of CURVE keys (`tremolo keygen`): the exchange is encrypted, and only their "
                  "owners take part")
      ->existing_folder();
  command.add_flag("--local", options.local,
                   "All processes on this machine, whatever the [hosts] of the case say");
  command
      .add_option("--threads", options.threads,
                  "Threads of the domain, or of each of its ranks; results do not depend on it (default: as "
                  "many as the machine runs at once, shared among the ranks)")
      ->between(1, most_threads);
  command
      .add_option("--ranks", options.ranks.count,
                  "Processes that share the domain, by MPI; results do not depend on it")
      ->between(1, most_ranks)
      ->capture_default_str();
  command.add_flag("--oversubscribe", options.ranks.oversubscribe,
                   "Start more ranks than the machines have processors");
}

} // namespace tremolo::app
