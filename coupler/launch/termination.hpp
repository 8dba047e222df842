#pragma once

#include <csignal>
#include <optional>

namespace tremolo::coupler {

/// While it lives, SIGINT, SIGTERM and SIGCHLD do not act but are read from a descriptor that can be polled.
/// To be made before any other thread starts, since threads inherit the blocked signals.
class SignalWatch {
public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

  /// SIGINT or SIGTERM if one has come since the last call. SIGCHLD only wakes the poll.
  std::optional<int> termination();

private:
  sigset_t previous_;
  int descriptor_;
};

} // namespace tremolo::coupler
