#pragma once

// Pace of a participant, and the time to wait for it before the run is aborted:
//
//     patience = max(deadline, 20 x the median of the last intervals between its signs of progress)
//
// A large model whose steps take long is slow, not stuck; a single long pause does not move the median.

#include "coupler/mapping/timing.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tremolo::coupler {

class Pace {
public:
  /// The participant owes something from now on; what came before is not its time.
  void asked(Clock::time_point now = Clock::now()) { since_ = now; }

  /// It has got on.
  void advanced(Clock::time_point now = Clock::now()) {
    intervals_[count_++ % intervals_.size()] = silence(now);
    since_ = now;
  }

  /// Since it last got on, or was asked, s.
  [[nodiscard]] double silence(Clock::time_point now = Clock::now()) const {
    return std::chrono::duration<double>(now - since_).count();
  }

  /// @param deadline the least patience, s
  [[nodiscard]] double patience(double deadline) const {
    constexpr double out_of_proportion = 20.0;
    constexpr std::size_t least_intervals =
        7; // fewer say nothing: the first one holds the start of a program
    if (count_ < least_intervals)
      return deadline;
    auto sorted = intervals_;
    const auto held = static_cast<std::ptrdiff_t>(std::min(count_, sorted.size()));
    const auto middle = sorted.begin() + held / 2;
    std::nth_element(sorted.begin(), middle, sorted.begin() + held);
    return std::max(deadline, out_of_proportion * *middle);
  }

private:
  std::array<double, 31> intervals_{};
  std::size_t count_ = 0;
  Clock::time_point since_ = Clock::now();
};

} // namespace tremolo::coupler
