#pragma once

#include "scene/case.hpp"

#include <filesystem>

namespace tremolo::app {

/// Computes the free field of a side of a complete case and records it (results/free_field_recording.hpp) as
/// tremolo-recording serves it: at the levels and times that the domain of this case requests.
/// @throws std::runtime_error if the file cannot be written, and as free_field_series()
void record_column(const scene::Case& scene, scene::Side side, const std::filesystem::path& file);

} // namespace tremolo::app
