#include "app/run/run_display.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace tremolo::app {

namespace {

constexpr double terminal_interval = 0.2; // s
constexpr double plain_interval = 5.0;    // s

std::string duration(double seconds) {
  const auto s = std::llround(seconds);
  if (s < 60)
    return fmt::format("{} s", s);
  if (s < 3600)
    return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s % 3600 / 60);
}

} // namespace

ProgressLine::ProgressLine()
    : terminal_(::isatty(STDOUT_FILENO) == 1), stage_start_(coupler::Clock::now()),
      last_shown_(stage_start_) {}

ProgressLine::~ProgressLine() {
  if (open_)
    std::fputs("\n", stdout);
}

void ProgressLine::show(const coupler::Progress& progress) {
  if (progress.stage != stage_) {
    stage_ = progress.stage;
    first_step_ = progress.step;
    first_time_ = progress.time;
    stage_start_ = coupler::Clock::now();
  }
  if (coupler::seconds_since(last_shown_) < (terminal_ ? terminal_interval : plain_interval))
    return;
  last_shown_ = coupler::Clock::now();
  const std::string text = progress_text(progress, progress.step - first_step_, progress.time - first_time_,
                                         coupler::seconds_since(stage_start_));
  // \r: to the line's start; ESC [K: erase what the longer line before has left.
  fmt::print("{}{}{}", terminal_ ? "\r" : "", text, terminal_ ? "\x1b[K" : "\n");
  std::fflush(stdout);
  open_ = terminal_;
}

void ProgressLine::note(const std::string& text) {
  if (open_)
    std::fputs("\n", stdout);
  open_ = false;
  std::fflush(stdout);
  fmt::print(stderr, "tremolo: {}\n", text);
}

std::string progress_text(const coupler::Progress& progress, std::uint64_t steps, double simulated,
                          double elapsed) {
  std::string text = fmt::format("{}: step {}", progress.stage, progress.step);
  if (progress.residual)
    text += fmt::format(", residual {:.2g}", *progress.residual);
  if (progress.end_time > 0.0)
    text += fmt::format(", simulated {:.2f} of {:.2f} s", progress.time, progress.end_time);
  if (steps > 0 && elapsed > 0.0)
    text += fmt::format(", {:.4g} steps/s", static_cast<double>(steps) / elapsed);
  if (simulated > 0.0)
    text += fmt::format(", {} left", duration((progress.end_time - progress.time) / simulated * elapsed));
  return text;
}

std::string summary_text(const std::vector<coupler::ProcessSummary>& processes) {
  std::string text =
      fmt::format("{:<34} {:>10} {:>10} {:>8}\n", "process / pass", "wall s", "cpu s", "share");
  for (const auto& process : processes) {
    const auto share = [&](double seconds) { return 100.0 * seconds / process.wall_seconds; };
    text += fmt::format("{:<34} {:>10.2f} {:>10}\n", process.name, process.wall_seconds,
                        std::isnan(process.cpu_seconds) ? "elsewhere"
                                                        : fmt::format("{:.2f}", process.cpu_seconds));
    for (const auto& pass : process.report.passes)
      text += fmt::format("  {:<32} {:>10.2f} {:>10} {:>6.1f} %\n", pass.name, pass.seconds, "",
                          share(pass.seconds));
    text += fmt::format("  {:<32} {:>10.2f} {:>10} {:>6.1f} %\n", "waiting for exchange",
                        process.report.waiting, "", share(process.report.waiting));
    for (const auto& [activity, slices] : process.report.timeline.activities)
      if (const double seconds = process.report.timeline.seconds(activity); activity != coupler::computing)
        text +=
            fmt::format("    {:<30} {:>10.2f} {:>10} {:>6.1f} %\n", activity, seconds, "", share(seconds));
    if (process.report.particle_updates > 0.0)
      text += fmt::format("  {:.3g} particle updates, {:.3g} per second of wall time\n",
                          process.report.particle_updates,
                          process.report.particle_updates / process.wall_seconds);
  }
  return text;
}

} // namespace tremolo::app
