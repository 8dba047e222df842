// Intervals that grow by a ratio g from D on have grown to D + (g - 1) t when t has passed, and there are
// log_g(1 + (g - 1) T/D) of them in a time T.

#include "scene/plan/output/intervals.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

bool rests_at(const Case& scene, double time) {
  return scene.rest && time >= scene.shaking.duration;
}

double intervals_in(double time, double first, double growth) {
  const double equal = time / first;
  return std::floor((growth > 1.0 ? std::log1p((growth - 1.0) * equal) / std::log(growth) : equal) + 1e-9);
}

/// The first time after `time` at which something is due. Times that have passed meanwhile are left out, and
/// a rest begins with one.
double next(const Case& scene, double due, double every, double time) {
  const double next = due + every * std::max(1.0, std::ceil((time - due) / every));
  const bool passes_start = scene.rest && time < scene.shaking.duration && next > scene.shaking.duration;
  return passes_start ? scene.shaking.duration : next;
}

double first_frame_interval(const Case& scene) {
  return scene.rest->every.value_or(scene.output.every);
}

double rest_row_interval(const Case& scene) {
  return scene.rest->history_every.value_or(scene.output.history_every);
}

} // namespace

double next_frame(const Case& scene, double due, double time) {
  const double grown = rests_at(scene, due) ? first_frame_interval(scene) +
                                                  (scene.rest->growth - 1.0) * (due - scene.shaking.duration)
                                            : scene.output.every;
  return next(scene, due, grown, time);
}

double next_row(const Case& scene, double due, double time) {
  return next(scene, due, rests_at(scene, due) ? rest_row_interval(scene) : scene.output.history_every, time);
}

std::int64_t most_frames(const Case& scene, double dt) {
  double frames = intervals_in(scene.shaking.duration, std::max(scene.output.every, dt), 1.0) + 1.0;
  if (scene.rest)
    frames +=
        intervals_in(scene.rest->duration, std::max(first_frame_interval(scene), dt), scene.rest->growth) +
        1.0;
  return std::llround(frames);
}

std::int64_t most_rows(const Case& scene, double dt) {
  double rows = intervals_in(scene.shaking.duration, std::max(scene.output.history_every, dt), 1.0) + 3.0;
  if (scene.rest)
    rows += intervals_in(scene.rest->duration, std::max(rest_row_interval(scene), dt), 1.0) + 1.0;
  return std::llround(rows);
}

} // namespace tremolo::scene
