#pragma once

#include "scene/case.hpp"

#include <cstdint>

namespace tremolo::scene {

/// The stage in which a time of the soil (s) lies.
const TimedStage& stage_at(const Case& scene, double time);

/// When the next frame, or row of the histories, is due after one that was due and has been written, s.
/// @param due,time  of the soil; when it was due, and when it was written, s
double next_frame(const Case& scene, double due, double time);
double next_row(const Case& scene, double due, double time);

/// Largest numbers of frames and rows that a run with steps of dt (s) writes: a step writes at most one.
std::int64_t most_frames(const Case& scene, double dt);
std::int64_t most_rows(const Case& scene, double dt);

} // namespace tremolo::scene
