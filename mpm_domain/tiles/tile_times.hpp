#pragma once

// What the particles of each tile cost a rank: the processor time of its gather and laws since the last deal.
// Sand that has liquefied costs many times what it cost before, so that equal numbers of particles are no
// equal shares of the work.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class TileTimes {
public:
  /// Nothing has been measured.
  void restart(std::size_t tiles) {
    nanoseconds_.assign(tiles, 0);
    steps_ = 0;
  }
  void count_step() { ++steps_; }
  /// Adds to the time of a tile. Any thread may call it.
  void add(std::size_t tile, std::int64_t nanoseconds) {
    std::atomic_ref(nanoseconds_[tile]).fetch_add(nanoseconds, std::memory_order_relaxed);
  }

  std::span<const std::int64_t> nanoseconds() const { return nanoseconds_; } ///< by tile
  std::int64_t steps() const { return steps_; }

private:
  std::vector<std::int64_t> nanoseconds_;
  std::int64_t steps_ = 0;
};

/// Measures what its thread does while it lives.
class TileTimer {
public:
  /// @param times  take the time of a tile; null: nobody does
  TileTimer(TileTimes* times, std::size_t tile) : times_(times), tile_(tile), begin_(times ? now() : 0) {}
  ~TileTimer() {
    if (times_ != nullptr)
      times_->add(tile_, now() - begin_);
  }
  TileTimer(const TileTimer&) = delete;
  TileTimer& operator=(const TileTimer&) = delete;

private:
  static std::int64_t now() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
  }

  TileTimes* times_;
  std::size_t tile_;
  std::int64_t begin_; ///< ns
};

} // namespace tremolo::mpm_domain
