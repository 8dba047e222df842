#pragma once

#include "materials/hysteretic/backbone/curves.hpp"

#include <filesystem>

namespace tremolo::scene {

/// Reads curves from a table with the header `strain,modulus_reduction,damping`, one strain a line, all
/// ratios of one (not per cent). Lines that start with # are comments.
/// @throws std::invalid_argument with file and line of what is wrong
materials::SoilCurves read_curve_table(const std::filesystem::path& file);

} // namespace tremolo::scene
