// Intervals that grow by a ratio g from D on have grown to D + (g - 1) t when t has passed, and there are
// log_g(1 + (g - 1) T/D) of them in a time T.
//
// A rest in which time passes F times as fast has, unless the case says otherwise, F times the intervals of
// the shaking: as many frames and rows for a second that is simulated.

#include "scene/plan/output/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::scene {

namespace {

double intervals_in(double time, double first, double growth) {
  const double equal = time / first;
  return std::floor((growth > 1.0 ? std::log1p((growth - 1.0) * equal) / std::log(growth) : equal) + 1e-9);
}

double first_frame_interval(const Case& scene, const TimedStage& stage) {
  const double every = scene.output.every;
  return stage.rest ? stage.rest->every.value_or(stage.rest->time_factor * every) : every;
}

double row_interval(const Case& scene, const TimedStage& stage) {
  const double every = scene.output.history_every;
  return stage.rest ? stage.rest->history_every.value_or(stage.rest->time_factor * every) : every;
}

/// A time at which something is due after `time`, or the start of a stage before it: each begins with one.
double or_start_of_stage(const Case& scene, double due, double time) {
  for (const TimedStage& stage : scene.timed)
    if (time < stage.start && due > stage.start)
      return stage.start;
  return due;
}

/// The first time after `time` at which something is due. Times that have passed meanwhile are left out.
double next(const Case& scene, double due, double every, double time) {
  return or_start_of_stage(scene, due + every * std::max(1.0, std::ceil((time - due) / every)), time);
}

/// The first of the given times of a rest after `time`; none of them: never.
double next_given(const TimedStage& stage, double time) {
  for (const double after_start : stage.rest->times)
    if (stage.start + after_start > time)
      return stage.start + after_start;
  return std::numeric_limits<double>::infinity();
}

} // namespace

const TimedStage& stage_at(const Case& scene, double time) {
  return *std::find_if(scene.timed.begin(), scene.timed.end() - 1,
                       [&](const TimedStage& stage) { return time < stage.end(); });
}

double next_frame(const Case& scene, double due, double time) {
  const TimedStage& stage = stage_at(scene, due);
  if (stage.rest && !stage.rest->times.empty())
    return or_start_of_stage(scene, next_given(stage, std::max(due, time)), time);
  const double first = first_frame_interval(scene, stage);
  return next(scene, due, stage.rest ? first + (stage.rest->growth - 1.0) * (due - stage.start) : first,
              time);
}

double next_row(const Case& scene, double due, double time) {
  return next(scene, due, row_interval(scene, stage_at(scene, due)), time);
}

std::int64_t most_frames(const Case& scene, double dt) {
  double frames = 0.0;
  for (const TimedStage& stage : scene.timed) {
    if (stage.rest && !stage.rest->times.empty()) {
      frames += static_cast<double>(stage.rest->times.size()) + 1.0;
      continue;
    }
    frames += intervals_in(stage.duration, std::max(first_frame_interval(scene, stage), dt),
                           stage.rest ? stage.rest->growth : 1.0) +
              1.0;
  }
  return std::llround(frames);
}

std::int64_t most_rows(const Case& scene, double dt) {
  double rows = 2.0;
  for (const TimedStage& stage : scene.timed)
    rows += intervals_in(stage.duration, std::max(row_interval(scene, stage), dt), 1.0) + 1.0;
  return std::llround(rows);
}

} // namespace tremolo::scene
