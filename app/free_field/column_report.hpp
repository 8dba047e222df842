#pragma once

#include "app/free_field/column/column_ground.hpp"
#include "app/free_field/series/free_field_series.hpp"
#include "results/run_file.hpp"
#include "scene/case.hpp"

#include <string>
#include <vector>

namespace tremolo::app {

/// Motion of the bare outcrop of the half-space under the same incident wave: acceleration of the horizontal
/// (SV) or vertical (P) component, m/s2, at the times of the series; empty where the case gives a motion
/// within the ground, whose outcrop is not known, and beyond the critical angle, where it is another shape.
std::vector<double> outcrop_acceleration(const scene::Case& scene, const scene::SourceProcess& source,
                                         const wavefield::TimeGrid& times);

/// Results of a free field for engineers (docs/output-format.md).
struct ColumnResults {
  std::vector<results::NamedTable> histories; ///< /monitors/PLACE: motion, stress and strain over time
  /// The tables, in the order of the histories:
  ///   /levels     places of the histories
  ///   /profile    peak values over depth
  ///   /spectra    response spectra at 5 % of critical damping, surface and outcrop
  ///   /transfer   Fourier amplitudes of surface, base and outcrop, and their ratios
  ///   /measures   intensity measures of the outcrop and at the places of the histories
  /// and those of site_tables(), and of water_tables() where the ground has pore pressure
  std::vector<results::NamedTable> tables;
};

/// "surface", or "8 m" for a depth of 8 m.
std::string place_name(double depth);

/// @param shown  levels of the histories, as indices into series.levels
ColumnResults column_results(const ColumnGround& ground, const FreeFieldSeries& series,
                             const std::vector<std::size_t>& shown);

} // namespace tremolo::app
