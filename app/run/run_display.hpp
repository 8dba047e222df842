#pragma once

// Display of `tremolo run`: a progress line while it runs, a summary at its end.

#include "coupler/launch/launcher.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tremolo::app {

/// One line that is rewritten on a terminal; a plain line every few seconds elsewhere.
class ProgressLine {
public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  void show(const coupler::Progress& progress);

  /// Prints a line of its own above the progress line.
  void note(const std::string& text);

private:
  bool terminal_;
  std::string stage_;
  std::uint64_t first_step_ = 0;
  double first_time_ = 0.0;
  coupler::Clock::time_point stage_start_;
  coupler::Clock::time_point last_shown_;
  bool open_ = false; ///< the cursor is at the end of an unfinished line
};

/// "simulated 3.20 of 20.00 s, 152 steps/s, 1 min 50 s left"
std::string progress_text(const coupler::Progress& progress, std::uint64_t steps, double simulated,
                          double elapsed);

/// Wall time of each process and pass, particle updates per second, share spent waiting for the exchange.
std::string summary_text(const std::vector<coupler::ProcessSummary>& processes);

} // namespace tremolo::app
