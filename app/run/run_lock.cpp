#include "app/run/run_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace tremolo::app {

namespace {

constexpr std::chrono::milliseconds pause{50};
constexpr int attempts = 60; ///< 3 s, more than a process needs to notice that its run has ended

} // namespace

RunLock::RunLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY)) { // without O_CLOEXEC: inherited
  for (int attempt = 0; descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0; ++attempt) {
    if (errno != EWOULDBLOCK)
      break; // a file system that knows no locks
    if (attempt == attempts) {
      ::close(descriptor_);
      throw std::runtime_error(
          fmt::format("{} is in use: processes of a run are still writing into it", folder.string()));
    }
    std::this_thread::sleep_for(pause);
  }
  if (descriptor_ < 0)
    throw std::runtime_error(
        fmt::format("cannot open {}: {}", folder.string(), std::generic_category().message(errno)));
}

RunLock::~RunLock() {
  ::close(descriptor_);
}

} // namespace tremolo::app
