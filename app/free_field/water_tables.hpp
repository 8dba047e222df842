#pragma once

#include "app/free_field/series/free_field_series.hpp"
#include "results/run_file.hpp"
#include "scene/case.hpp"

#include <string>
#include <vector>

namespace tremolo::app {

/// Whether a free field has soil below the water table and a model that computes its pore pressure.
bool has_pore_pressure(const scene::Case& scene, const scene::SourceProcess& source);

/// Vertical effective stress before shaking at a level, compression positive, Pa: the weight of what lies
/// above less the pressure of water at rest.
double initial_effective_stress(const scene::Case& scene, const scene::SourceProcess& source, double y);

/// Columns of a history that only wet ground has: excess pore pressure, its ratio r_u to the initial
/// effective stress, and the vertical effective stress, compression positive.
void add_water(const scene::Case& scene, const scene::SourceProcess& source, const FreeFieldSeries& series,
               std::size_t level, results::Table& history);

/// Tables for judging a liquefying free field (docs/output-format.md):
///   /water       excess pore pressure over depth and time
///   /settlement  of the surface relative to the base, over time
///   /initial     effective stress and pore pressure before shaking, largest r_u, settlement at the end, over
///   depth
std::vector<results::NamedTable> water_tables(const scene::Case& scene, const scene::SourceProcess& source,
                                              const FreeFieldSeries& series);

/// Largest r_u, where, and the settlement, in words.
std::string water_summary(const scene::Case& scene, const scene::SourceProcess& source,
                          const FreeFieldSeries& series);

} // namespace tremolo::app
