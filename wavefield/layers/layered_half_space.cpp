#include "wavefield/layers/layered_half_space.hpp"

#include "base/require.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;

/// Complex over undamped modulus.
Complex factor(const Damping& damping, double ratio, Complex s) {
  const double omega_0 = 2.0 * std::numbers::pi * damping.reference_hz;
  switch (damping.model) {
  case DampingModel::none:
    return 1.0;
  case DampingModel::hysteretic:
    return {1.0, 2.0 * ratio};
  case DampingModel::shake:
    return {1.0 - 2.0 * ratio * ratio, 2.0 * ratio * std::sqrt(1.0 - ratio * ratio)};
  case DampingModel::kelvin_voigt:
    return 1.0 + 2.0 * ratio * s / omega_0;
  case DampingModel::kjartansson:
    return s == 0.0 ? 1.0 : std::pow(s / omega_0, 2.0 * std::atan(2.0 * ratio) / std::numbers::pi);
  }
  throw std::logic_error("a damping model without a formula");
}

void validate_ratio(const std::string& what, double ratio, DampingModel model) {
  require(ratio >= 0.0 && ratio < 0.5, what, ratio, "in [0, 0.5)");
  require(ratio == 0.0 || model != DampingModel::none, what, ratio,
          "0 where the damping model is `none`: name a damping model");
}

void validate(const Layer& layer, const std::string& which, DampingModel model) {
  require_positive(which + "thickness", layer.thickness, "m");
  require_positive(which + "density", layer.density, "kg/m3");
  require_positive(which + "vs", layer.vs, "m/s");
  require_positive(which + "vp", layer.vp, "m/s");
  const double lowest = std::sqrt(4.0 / 3.0) * layer.vs;
  require(layer.vp > lowest, which + "vp", layer.vp,
          "above sqrt(4/3) vs, here " + shortest(lowest) + " m/s, for a positive bulk modulus");
  validate_ratio(which + "damping ratio", layer.damping, model);
  validate_ratio(which + "damping ratio of P waves", layer.damping_p.value_or(layer.damping), model);
}

} // namespace

double LayeredHalfSpace::thickness() const {
  double sum = 0.0;
  for (const Layer& layer : layers)
    sum += layer.thickness;
  return sum;
}

ComplexModuli moduli(const LayeredHalfSpace& profile, std::size_t index, Complex s) {
  if (index == profile.layers.size()) {
    const HalfSpace& deep = profile.half_space;
    const Complex damped = factor(profile.damping, profile.half_space_damping, s);
    return {deep.density * deep.vs * deep.vs * damped, deep.density * deep.vp * deep.vp * damped};
  }
  const Layer& layer = profile.layers[index];
  return {layer.density * layer.vs * layer.vs * factor(profile.damping, layer.damping, s),
          layer.density * layer.vp * layer.vp *
              factor(profile.damping, layer.damping_p.value_or(layer.damping), s)};
}

bool is_frequency_independent(DampingModel model) {
  return model != DampingModel::kelvin_voigt && model != DampingModel::kjartansson;
}

bool is_constant_damping(DampingModel model) {
  return model == DampingModel::hysteretic || model == DampingModel::shake;
}

bool is_damped(const LayeredHalfSpace& profile) {
  if (profile.half_space_damping > 0.0)
    return true;
  for (const Layer& layer : profile.layers)
    if (layer.damping > 0.0 || layer.damping_p.value_or(0.0) > 0.0)
      return true;
  return false;
}

std::string_view name(DampingModel model) {
  switch (model) {
  case DampingModel::none:
    return "none";
  case DampingModel::hysteretic:
    return "hysteretic";
  case DampingModel::shake:
    return "shake";
  case DampingModel::kelvin_voigt:
    return "kelvin_voigt";
  case DampingModel::kjartansson:
    return "kjartansson";
  }
  throw std::logic_error("a damping model without a name");
}

void validate(const LayeredHalfSpace& profile) {
  validate(profile.half_space);
  validate_ratio("half-space damping ratio", profile.half_space_damping, profile.damping.model);
  for (std::size_t i = 0; i < profile.layers.size(); ++i)
    validate(profile.layers[i], "layer " + std::to_string(i + 1) + " from the top: ", profile.damping.model);
  if (!is_frequency_independent(profile.damping.model)) {
    require_positive("reference frequency of " + std::string(name(profile.damping.model)) + " damping",
                     profile.damping.reference_hz, "Hz");
  }
}

} // namespace tremolo::wavefield
