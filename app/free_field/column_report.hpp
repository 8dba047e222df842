#pragma once

#include "app/free_field/free_field_series.hpp"
#include "results/run_file.hpp"
#include "scene/case.hpp"

#include <vector>

namespace tremolo::app {

/// Motion of the bare outcrop of the half-space under the same incident wave: acceleration of the horizontal
/// (SV) or vertical (P) component, m/s2, at the times of the series; empty where the case gives a motion
/// within the ground, whose outcrop is not known, and beyond the critical angle, where it is another shape.
std::vector<double> outcrop_acceleration(const scene::Case& scene, const scene::SourceProcess& source,
                                         const wavefield::TimeGrid& times);

/// What engineers look at in a free field, as tables (docs/output-format.md):
///   /histories/LEVEL  motion, stress and strain at the depths asked for
///   /profile          peak values over depth
///   /spectra          response spectra at 5 % of critical damping, surface and outcrop
///   /transfer         Fourier amplitudes of the surface over those of outcrop and base
/// and those of water_tables() where the ground has pore pressure
/// @param shown  levels of the histories, as indices into series.levels
std::vector<results::NamedTable> column_tables(const scene::Case& scene, const scene::SourceProcess& source,
                                               const FreeFieldSeries& series,
                                               const std::vector<std::size_t>& shown);

} // namespace tremolo::app
