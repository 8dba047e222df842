// Damping ratios of a harmonic motion of angular frequency w (Chopra 2012, Dynamics of Structures,
// sec. 11.4):
//
//     Rayleigh, xi = alpha / (2 w) + beta w / 2, equal at w_1 and w_2:
//         alpha = 2 xi w_1 w_2 / (w_1 + w_2),   beta = 2 xi / (w_1 + w_2)
//     Kelvin-Voigt, xi = beta w / 2 at w_0:
//         beta = 2 xi / w_0

#include "freefield/profile.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::freefield {
namespace {

bool positive(double value) {
  return value > 0.0 && std::isfinite(value);
}

void validate_soil(const materials::Elasticity& soil, const std::string& place) {
  require(positive(soil.density), place + ": density", soil.density, "positive, in kg/m3");
  require(positive(soil.young), place + ": Young's modulus", soil.young, "positive, in Pa");
  require(soil.poisson > -1.0 && soil.poisson < 0.5, place + ": Poisson's ratio", soil.poisson,
          "in (-1, 0.5)");
  require(soil.rest_coefficient() >= 0.0 && std::isfinite(soil.rest_coefficient()),
          place + ": coefficient of earth pressure at rest", soil.rest_coefficient(), "at least 0");
}

void validate_law(const Layer& layer, const std::string& place) {
  if (!layer.law)
    return;
  try {
    materials::validate(*layer.law);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(place + ": " + error.what());
  }
  const materials::Elasticity& elastic = materials::elasticity(*layer.law);
  if (elastic.density != layer.soil.density || elastic.young != layer.soil.young ||
      elastic.poisson != layer.soil.poisson)
    throw std::invalid_argument(place + ": the elastic constants of the layer are not those of its law");
}

void validate_pores(const Layer& layer, const std::optional<WaterTable>& water, double top,
                    const std::string& place) {
  if (!layer.pores)
    return;
  if (!water)
    throw std::invalid_argument(place + ": the layer has pore water, but the profile has no water table");
  materials::validate(water->fluid);
  try {
    materials::validate(*layer.pores);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(place + ": " + error.what());
  }
  const double saturated = materials::saturated_density(*layer.pores, water->fluid);
  require(std::abs(layer.soil.density - saturated) <= 1e-9 * saturated, place + ": density",
          layer.soil.density, "that of its grains and water, " + shortest(saturated) + " kg/m3");
  const double rounding = 1e-9 * (1.0 + std::abs(water->level));
  require(top <= water->level + rounding, place + ": y of its top", top,
          "at or below the water table, " + shortest(water->level) + " m");
}

} // namespace

Layer layer_of(double thickness, const materials::Law& law, double damping_ratio) {
  return {
      .thickness = thickness, .soil = materials::elasticity(law), .damping_ratio = damping_ratio, .law = law};
}

double Profile::base_level() const {
  double level = surface_level;
  for (const Layer& layer : layers)
    level -= layer.thickness;
  return level;
}

double Profile::hydrostatic_pressure(double y) const {
  return water ? water->fluid.density * gravity * std::max(water->level - y, 0.0) : 0.0;
}

DampingCoefficients coefficients(const Damping& damping, double ratio) {
  constexpr double two_pi = 2.0 * std::numbers::pi;
  if (ratio == 0.0 || std::holds_alternative<ConstantDamping>(damping))
    return {};
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&damping)) {
    const double w1 = two_pi * rayleigh->first_frequency_hz;
    const double w2 = two_pi * rayleigh->second_frequency_hz;
    return {2.0 * ratio * w1 * w2 / (w1 + w2), 2.0 * ratio / (w1 + w2)};
  }
  return {0.0, 2.0 * ratio / (two_pi * std::get<KelvinVoigtDamping>(damping).reference_frequency_hz)};
}

materials::Relaxation relaxation(const Damping& damping, double ratio) {
  const auto* constant = std::get_if<ConstantDamping>(&damping);
  return constant ? materials::relaxation(*constant, ratio) : materials::Relaxation{};
}

void validate(const Profile& profile) {
  require(std::isfinite(profile.surface_level), "level of the free surface", profile.surface_level, "finite");
  if (profile.layers.empty())
    throw std::invalid_argument("the profile has no layer, must have at least one");
  double top = profile.surface_level;
  for (std::size_t i = 0; i < profile.layers.size(); ++i) {
    const Layer& layer = profile.layers[i];
    const std::string place = "layer " + std::to_string(i + 1) + " from the top";
    require(positive(layer.thickness), place + ": thickness", layer.thickness, "positive, in m");
    require(layer.damping_ratio >= 0.0 && layer.damping_ratio < 1.0, place + ": damping ratio",
            layer.damping_ratio, "in [0, 1)");
    validate_soil(layer.soil, place);
    validate_law(layer, place);
    validate_pores(layer, profile.water, top, place);
    top -= layer.thickness;
  }
  require(profile.gravity >= 0.0 && std::isfinite(profile.gravity), "gravity", profile.gravity,
          "at least 0, in m/s2");
  validate_soil(profile.half_space, "half-space");
}

void validate(const Damping& damping) {
  if (const auto* constant = std::get_if<ConstantDamping>(&damping))
    return materials::validate(*constant);
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&damping)) {
    require(positive(rayleigh->first_frequency_hz), "first Rayleigh frequency", rayleigh->first_frequency_hz,
            "positive, in Hz");
    require(rayleigh->second_frequency_hz > rayleigh->first_frequency_hz &&
                std::isfinite(rayleigh->second_frequency_hz),
            "second Rayleigh frequency", rayleigh->second_frequency_hz,
            "above the first, " + shortest(rayleigh->first_frequency_hz) + " Hz");
    return;
  }
  const double frequency = std::get<KelvinVoigtDamping>(damping).reference_frequency_hz;
  require(positive(frequency), "reference frequency of Kelvin-Voigt damping", frequency, "positive, in Hz");
}

} // namespace tremolo::freefield
