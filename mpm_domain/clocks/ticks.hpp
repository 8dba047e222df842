#pragma once

// The ticks of one step. Clock r ticks every dt_r = dt_0/2^r, and a step is one of clock 0: 2^(clocks - 1)
// ticks of the fastest one. A mesh whose levels all take the same step has one clock, and its step is one
// tick.

#include <bit>

namespace tremolo::mpm_domain {

class Ticks {
public:
  explicit Ticks(int clocks) : clocks_(clocks) {}

  /// Sets the times of the step that begins, s: its length dt_0 and the time `kick` for which forces act at
  /// its first tick (Step::kick).
  void set_step(double dt, double kick) {
    dt_ = dt;
    kick_ = kick;
  }

  int clocks() const { return clocks_; }
  int count() const { return 1 << (clocks_ - 1); }
  int now() const { return tick_; }
  bool is_first() const { return tick_ == 0; }
  /// The slowest clock that begins a step at this tick, and the slowest that ends one with it; all faster
  /// ones do so too.
  int first_due() const { return slowest_at(tick_); }
  int first_ending() const { return slowest_at(tick_ + 1); }
  double dt_of(int clock) const { return dt_ / static_cast<double>(1 << clock); }
  /// Time that the forces of a clock act for at this tick, s: all clocks change their step together.
  double kick_of(int clock) const { return (is_first() ? kick_ : dt_) / static_cast<double>(1 << clock); }
  /// Factor of a clock's force that acts at every tick, so that it adds up to kick_of(clock) in the clock's
  /// step.
  double steady_share(int clock) const { return tick_ > 0 && tick_ < count() >> clock ? kick_ / dt_ : 1.0; }

  /// Goes on to the next tick.
  /// @returns false after the last one of the step
  bool next() {
    tick_ = (tick_ + 1) % count();
    return tick_ != 0;
  }

private:
  int slowest_at(int tick) const {
    const auto position = static_cast<unsigned>(tick % count());
    return position == 0 ? 0 : clocks_ - 1 - std::countr_zero(position);
  }

  int clocks_;
  int tick_ = 0;
  double dt_ = 0.0;
  double kick_ = 0.0;
};

} // namespace tremolo::mpm_domain
