#pragma once

// Activities of a participant's thread over time: it computes, it waits for somebody, or it maps, which is
// the work of the exchange itself (frames packed and checked, mapping in depth and time, Eq. (6)).
//
//     Timeline timeline;                              // computing from now on
//     {
//       const auto waiting = timeline.enter(waiting_for("right"));
//       ...
//     }                                               // what it did before
//
// Seconds are summed in slices of wall time. There are 256 at most: a run that takes longer has slices twice
// as long, then four times, so that a timeline costs the same memory and the same bytes whatever the run.

#include "coupler/mapping/timing.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::coupler {

inline constexpr std::string_view computing = "computing";
inline constexpr std::string_view mapping = "mapping";

/// "waiting for right"
std::string waiting_for(std::string_view whom);

/// Seconds of each activity in each slice of wall time since WELCOME, which all participants get at once.
struct TimelineReport {
  double slice = 0.0; ///< wall time of a slice, s
  std::map<std::string, std::vector<double>, std::less<>> activities;

  /// Total time of an activity over the run, s.
  [[nodiscard]] double seconds(std::string_view activity) const;

  /// Who waits for somebody who waits in turn waits for a third: names the third instead.
  void resolve_waits(std::string_view whom, TimelineReport of_whom);

  /// Slices of twice the length.
  void coarsen();
};

class Timeline {
public:
  /// @param slice the shortest slices, s
  explicit Timeline(double slice = 1.0 / 64.0);

  /// Until it is destroyed, an activity goes on.
  class Scope {
  public:
    Scope(Timeline& timeline, std::string activity);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    Timeline& timeline_;
    std::string before_;
  };
  [[nodiscard]] Scope enter(std::string_view activity) { return {*this, std::string(activity)}; }

  /// Starts the next activity.
  void turn_to(std::string activity);

  /// Up to now.
  [[nodiscard]] const TimelineReport& report();

private:
  void add(double from, double to);

  TimelineReport report_;
  std::string activity_{computing};
  Clock::time_point start_ = Clock::now();
  double until_ = 0.0; ///< since the start, what has been added, s
};

} // namespace tremolo::coupler
