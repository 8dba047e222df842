#pragma once

#include "app/free_field/column/column_ground.hpp"

#include <vector>

namespace tremolo::app {

/// Levels (m, ascending) of the peak profiles, which are even, with each interface twice and the depths of
/// the histories.
/// @throws std::runtime_error for a depth outside the column
std::vector<double> profile_levels(const ColumnGround& ground, const std::vector<double>& depths);

/// Depths of the histories, m: the requested ones, once each, otherwise surface, interfaces and base. Slices
/// of one soil have no interface between them.
std::vector<double> history_depths(const ColumnGround& ground, const std::vector<double>& asked);

} // namespace tremolo::app
