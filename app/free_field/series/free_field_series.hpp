#pragma once

#include "freefield/column.hpp"
#include "scene/case.hpp"
#include "scene/plan/plan.hpp"
#include "wavefield/layers/equivalent_linear.hpp"
#include "wavefield/signal/history.hpp"
#include "wavefield/superposition.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::app {

/// A free field on its vertical line, at levels and even times: the same for every model.
struct FreeFieldSeries {
  std::vector<double> levels; ///< m, ascending; an interface twice, from below and from above
  wavefield::TimeGrid times;
  std::vector<freefield::ColumnSample> samples; ///< [level][time]
  double cpu_seconds = 0.0;                     ///< that computing it took
  std::string report;                           ///< what integrator or iteration did, in words; may be empty
  std::optional<wavefield::EquivalentLinearResult> equivalent_linear; ///< of model eql

  std::span<const freefield::ColumnSample> at(std::size_t level) const {
    return std::span(samples).subspan(level * times.count, times.count);
  }
};

/// Largest absolute value of a member, in its unit.
double peak(std::span<const freefield::ColumnSample> samples, double freefield::ColumnSample::*member);

/// The level at which the peak of a member is largest; the lowest of several.
std::size_t peak_level(const FreeFieldSeries& series, double freefield::ColumnSample::*member);

/// The clock of a series' times: the two differ in a rest with a time factor
/// (materials/water/soil_clock.hpp).
enum class TimeOf { simulation, soil };

/// Computes a free field in this process with the model of the source: wave, fe, ode, eql or mpm.
/// Between the steps of a column, velocity, displacement and stress are cubic Hermite, strain and pore
/// pressure linear.
/// @param x_line  where the line stands, m
/// @param time  of `times`, and of all rates
/// @throws std::invalid_argument for another model, or values out of range
FreeFieldSeries free_field_series(const scene::Case& scene, const scene::SourceProcess& source,
                                  std::vector<double> levels, const wavefield::TimeGrid& times, double x_line,
                                  TimeOf time = TimeOf::simulation);

/// Plane waves whose field is known, or their incident part alone, at levels of the half-space.
FreeFieldSeries plane_wave_series(const wavefield::Superposition& field, std::vector<double> levels,
                                  const wavefield::TimeGrid& times, double x_line, wavefield::Part part);

} // namespace tremolo::app
