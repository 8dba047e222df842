#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace tremolo {

/// Resource limits of a process.
struct ProcessLimits {
  std::uint64_t memory_bytes = 0; ///< more than this process has
  unsigned cpu_seconds = 0;
};

/// The text that `work` returns, done in a copy of this process, which it cannot crash, stall or exhaust: for
/// libraries that do not stand damaged files. No other thread may run.
/// @throws std::runtime_error with what `work` threw, or how its process ended
std::string in_own_process(const std::function<std::string()>& work, const ProcessLimits& limits);

} // namespace tremolo
