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
  command.add_option("--threads", options.threads, "Threads of the domain; results do not depend on it")
      ->between(1, most_threads)
      ->capture_default_str();
}

} // namespace tremolo::app
