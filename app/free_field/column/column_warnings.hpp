#pragma once

#include "app/free_field/column/column_ground.hpp"
#include "app/free_field/series/free_field_series.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::app {

/// Warnings about a free field: strain beyond the range of equivalent linear or linear soil, motion above the
/// frequency that the elements resolve, backbones without the given strength.
std::vector<std::string> column_warnings(const ColumnGround& ground, const FreeFieldSeries& series);

/// Highest frequency of shear waves that have `per_wavelength` elements of a size (m) at the secant stiffness
/// of the largest strain, where that is least.
struct CarriedFrequency {
  double frequency = 0.0; ///< Hz
  double depth = 0.0;     ///< m below the surface, where it is least
};
CarriedFrequency carried_frequency(const ColumnGround& ground, const FreeFieldSeries& series, double size,
                                   double per_wavelength);

/// Share of the power (squared Fourier amplitudes) of samples every dt (s) above a frequency (Hz).
double power_above(std::span<const double> samples, double dt, double frequency);

} // namespace tremolo::app
