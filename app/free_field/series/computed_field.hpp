#pragma once

#include "app/free_field/series/free_field_series.hpp"
#include "materials/water/soil_clock.hpp"

#include <array>
#include <memory>
#include <string>

namespace tremolo::app {

/// A free field that this process computes.
class ComputedField {
public:
  virtual ~ComputedField() = default;
  /// Computes what the series asks for, with its report. Once only: a column does not go back in time.
  /// @param clock  of the times of the series
  virtual void fill(FreeFieldSeries& series, const materials::SoilClock& clock) = 0;
  /// Says in a few words what the field is.
  virtual std::string description() const = 0;
  /// Shows at two times whether the ground lets the wave go; a column has shown it when it was made.
  /// @param y  level of the surface, m
  /// @throws as wavefield::LayeredField::sample()
  virtual void try_surface(double y, double from, double to) const = 0;
};

/// The field of a source in its model; the table of models is that of `computed` in
/// scene/plan/free_field_traits.hpp.
/// @param x_line  where its line stands, m
/// @param needed_from  when it is first asked for, s
/// @throws std::invalid_argument for a model that is not computed here, or values out of range
std::unique_ptr<ComputedField> computed_field(const scene::Case& scene, const scene::SourceProcess& source,
                                              double x_line, double needed_from);

/// Samples plane waves at a point of the surface at two times, which shows whether the ground lets them go.
/// @param displacement  whether their displacement must stay finite too
template <class Waves>
void sample_surface(const Waves& waves, wavefield::Point surface, double from, double to, bool displacement) {
  waves.sample(std::array{surface}, {from, to - from, 2}, wavefield::Part::total,
               {.displacement = displacement, .stress = false, .strain = false});
}

/// Fills a series with plane waves.
void synthesise(const wavefield::Superposition& field, double x, wavefield::Part part,
                FreeFieldSeries& series);

} // namespace tremolo::app
