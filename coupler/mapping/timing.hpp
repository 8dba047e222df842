#pragma once

#include <chrono>
#include <string>

namespace tremolo::coupler {

/// Deadlines and timings use the monotonic clock only: the wall clock may jump.
using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A named pass of a participant's step and the wall time it took in the whole run, s.
struct PassTime {
  std::string name;
  double seconds = 0.0;
};

/// Adds up the time between start() and stop().
class Stopwatch {
public:
  void start() { start_ = Clock::now(); }
  void stop() { sum_ += Clock::now() - start_; }
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(sum_).count(); }

private:
  Clock::time_point start_;
  Clock::duration sum_{0};
};

} // namespace tremolo::coupler
