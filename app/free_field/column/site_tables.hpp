#pragma once

#include "app/free_field/column/column_ground.hpp"
#include "app/free_field/series/free_field_series.hpp"
#include "results/run_file.hpp"

#include <vector>

namespace tremolo::app {

/// Tables of a site before shaking, and of its strain-compatible properties (docs/output-format.md):
///   /layers             from the surface down, the half-space last
///   /site               Vs30, period, impedance: one row
///   /strain_compatible  stiffness and damping that model eql ended with; of that model alone
std::vector<results::NamedTable> site_tables(const ColumnGround& ground, const FreeFieldSeries& series);

} // namespace tremolo::app
