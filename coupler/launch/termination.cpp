#include "coupler/launch/termination.hpp"

#include "coupler/wire/error.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace tremolo::coupler {

SignalWatch::SignalWatch() : previous_(), descriptor_(-1) {
  sigset_t watched;
  sigemptyset(&watched);
  sigaddset(&watched, SIGINT);
  sigaddset(&watched, SIGTERM);
  sigaddset(&watched, SIGCHLD);
  pthread_sigmask(SIG_BLOCK, &watched, &previous_);
  descriptor_ = ::signalfd(-1, &watched, SFD_NONBLOCK | SFD_CLOEXEC);
  if (descriptor_ < 0) {
    const int error = errno;
    pthread_sigmask(SIG_SETMASK, &previous_, nullptr);
    throw Error(fmt::format("cannot watch signals: {}", std::strerror(error)));
  }
}

SignalWatch::~SignalWatch() {
  ::close(descriptor_);
  pthread_sigmask(SIG_SETMASK, &previous_, nullptr);
}

std::optional<int> SignalWatch::termination() {
  std::optional<int> found;
  signalfd_siginfo info{};
  while (::read(descriptor_, &info, sizeof info) == sizeof info)
    if (info.ssi_signo != SIGCHLD)
      found = static_cast<int>(info.ssi_signo);
  return found;
}

} // namespace tremolo::coupler
