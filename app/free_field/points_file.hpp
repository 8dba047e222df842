#pragma once

#include "wavefield/layers/layered_field.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace tremolo::app {

/// Reads points of the soil from a comma-separated file: the header "x,y", then one point (m) a line. Blank
/// lines are left out.
/// @throws std::runtime_error naming file and line for anything else: another header, a value that is missing
/// or not a finite number, a point above the free surface (y of the surface, m), no point at all
std::vector<wavefield::Point> read_points(const std::filesystem::path& file, double surface_level);

/// Times from "T0:T1:DT" (s): T0, T0 + DT, ... up to T1, which is among them where DT divides T1 - T0.
/// @throws std::invalid_argument with the text and what is wrong with it
wavefield::TimeGrid parse_times(std::string_view text);

/// Frequencies from "F0:F1:DF" (Hz), as parse_times() reads times; F0 > 0.
/// @throws std::invalid_argument with the text and what is wrong with it
std::vector<double> parse_frequencies(std::string_view text);

} // namespace tremolo::app
