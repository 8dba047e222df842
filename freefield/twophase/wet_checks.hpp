#pragma once

#include "freefield/column.hpp"
#include "freefield/column_mesh.hpp"
#include "freefield/column_soil.hpp"
#include "freefield/profile.hpp"
#include "freefield/twophase/wet_energy.hpp"
#include "freefield/twophase/wet_grid.hpp"
#include "materials/water/soil_clock.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::freefield {

/// Conditions that every column of soil and water imposes on its ground and its steps.
/// @throws std::invalid_argument naming the quantity, its value and the allowed range
void validate_march(const Profile& profile, const Damping& damping, double time_step, double start_time);

/// A column before it moves.
struct RestingColumn {
  ColumnMesh mesh;
  WetGrid grid;
  std::vector<double> moduli; ///< M of the skeleton in each element while nothing relaxes, Pa
};

/// @throws std::invalid_argument for a profile with values out of range, or an initial stress beyond the
/// soil's
///         strength
RestingColumn resting_column(const Profile& profile, double max_element_size, const Damping& damping);

/// Lets all soil be shaken or reconsolidate, and its water flow, as the clock says.
void follow_clock(const materials::SoilClock& clock, double time, ColumnSoil& soil, WetGrid& grid);

/// @throws std::runtime_error where an element has strained so much that its porosity has left 0.01 to 0.95
void require_pores(const WetGrid& grid, const ColumnMesh& mesh, double time);

/// Stiffness that goes with pressure can multiply in dilation.
/// @throws std::runtime_error if the step is over the limit
void require_stable(double time_step, double limit, double time);

/// @throws std::invalid_argument if the levels to sample are not as many as the samples
void require_same_size(std::span<const double> y, std::span<const ColumnSample> samples);

/// The end of a column's report: how much of the energy given is missing; empty where nothing was given.
std::string missing_energy(const WetEnergy& spent);

} // namespace tremolo::freefield
