#include "app/free_field/column/column_warnings.hpp"

#include "motion/spectra.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/wave/resolution.hpp"
#include "scene/soils/domain_soils.hpp"
#include "scene/soils/soil_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::app {

namespace {

using freefield::ColumnSample;

/// Beyond it equivalent linear analyses depart from records (Kaklamanos, Bradley, Thompson & Baise 2013,
/// Bull. Seism. Soc. Am. 103, 3023-3042: 0.1 to 0.4 %).
constexpr double largest_of_equivalent_linear = 1e-3;
/// Beyond it soil is no longer linear (the same: 0.01 to 0.1 %).
constexpr double largest_of_linear = 5e-4;
/// Elements of a column that a wavelength needs (docs/free-fields/fe-column.md).
constexpr double elements_per_wavelength = 10.0;
/// The share of the power of the base's motion that may lie above what elements carry, 1.
constexpr double tolerated_power = 0.05;

/// The layer at a level; at an interface the one above, or the one below if the level means the limit from
/// there.
const scene::Layer& layer_at(const ColumnGround& ground, const FreeFieldSeries& series, std::size_t level) {
  const auto& layers = scene::layers(ground.scene, ground.source);
  const bool below = freefield::from_below(series.levels, level);
  double bottom = ground.source.surface;
  for (const scene::Layer& layer : layers) {
    bottom -= layer.thickness;
    if (series.levels[level] > bottom || (!below && series.levels[level] == bottom))
      return layer;
  }
  return layers.back();
}

bool follows_strain(const scene::Case& scene, const std::vector<scene::Layer>& layers) {
  return std::ranges::any_of(
      layers, [&](const scene::Layer& layer) { return layer.soil && scene.soils[*layer.soil].curves; });
}

void add_strain(const ColumnGround& ground, const FreeFieldSeries& series,
                std::vector<std::string>& warnings) {
  const scene::FreeFieldTraits& model = scene::traits(ground.source.field.model);
  const bool iterated = model.soil == scene::SoilTreatment::equivalent_linear;
  const std::size_t level = peak_level(series, &ColumnSample::gxy);
  const double strain = peak(series.at(level), &ColumnSample::gxy);
  if (model.soil == scene::SoilTreatment::by_law ||
      !follows_strain(ground.scene, scene::layers(ground.scene, ground.source)) ||
      strain <= (iterated ? largest_of_equivalent_linear : largest_of_linear))
    return;
  const auto where = fmt::format("shear strain reaches {:.3g} % at {:.4g} m below the surface",
                                 100.0 * strain, ground.source.surface - series.levels[level]);
  warnings.push_back(
      iterated
          ? fmt::format("{}: equivalent linear soil is for strains up to {} % or so; compare with a "
                        "model that is marched in time",
                        where, 100.0 * largest_of_equivalent_linear)
          : fmt::format("{}, where the soil yields: linear soil is for strains up to {} % or so, and its "
                        "accelerations are upper bounds beyond it",
                        where, 100.0 * largest_of_linear));
}

void add_frequency(const ColumnGround& ground, const FreeFieldSeries& series,
                   std::vector<std::string>& warnings) {
  const scene::FreeFieldTraits& model = scene::traits(ground.source.field.model);
  if (!model.marched_in_time)
    return;
  const double size = model.element_size(ground.scene);
  const double per_wavelength = model.of_domain_cells ? scene::cells_per_wavelength : elements_per_wavelength;
  const auto carried = carried_frequency(ground, series, size, per_wavelength);
  std::vector<double> base;
  for (const ColumnSample& sample : series.at(0))
    base.push_back(ground.scene.motion.wave == scene::Wave::sv ? sample.vx_rate : sample.vy_rate);
  const double share = power_above(base, series.times.dt, carried.frequency);
  if (share > tolerated_power)
    warnings.push_back(fmt::format(
        "elements of {:.3g} m carry shear waves up to {:.3g} Hz ({:g} a wavelength, at the secant stiffness "
        "{:.4g} m below the surface), and {:.2g} % of the power of the base's acceleration lie above: halve "
        "the elements and compare",
        size, carried.frequency, per_wavelength, carried.depth, 100.0 * share));
}

void add_strength(const ColumnGround& ground, std::vector<std::string>& warnings) {
  for (const auto& [name, soil] : scene::named_soils(ground.scene))
    if (const auto compared = scene::implied_strength(soil); compared && !compared->near)
      warnings.push_back(compared->text);
}

} // namespace

CarriedFrequency carried_frequency(const ColumnGround& ground, const FreeFieldSeries& series, double size,
                                   double per_wavelength) {
  CarriedFrequency carried{std::numeric_limits<double>::infinity()};
  const double most = peak(series.at(peak_level(series, &ColumnSample::gxy)), &ColumnSample::gxy);
  for (std::size_t k = 0; k < series.levels.size(); ++k) {
    const scene::Layer& layer = layer_at(ground, series, k);
    const double strain = peak(series.at(k), &ColumnSample::gxy);
    const double depth = ground.source.surface - series.levels[k];
    // A secant is meaningless where there is hardly any strain, and in the top element, whose strain is
    // uniform while its stress is not.
    const double secant = depth >= size && strain > 1e-2 * most
                              ? peak(series.at(k), &ColumnSample::sxy) / strain
                              : std::numeric_limits<double>::infinity();
    const double speed = std::min(std::sqrt(secant / layer.elastic.density), layer.elastic.s_wave_speed());
    if (const double frequency = speed / (per_wavelength * size); frequency < carried.frequency)
      carried = {frequency, depth};
  }
  return carried;
}

double power_above(std::span<const double> samples, double dt, double frequency) {
  double all = 0.0;
  double above = 0.0;
  for (const auto& bin : motion::fourier_spectrum(samples, dt)) {
    const double power = bin.amplitude * bin.amplitude;
    all += power;
    above += bin.frequency > frequency ? power : 0.0;
  }
  return all > 0.0 ? above / all : 0.0;
}

std::vector<std::string> column_warnings(const ColumnGround& ground, const FreeFieldSeries& series) {
  std::vector<std::string> warnings;
  add_strain(ground, series, warnings);
  add_frequency(ground, series, warnings);
  add_strength(ground, warnings);
  return warnings;
}

} // namespace tremolo::app
