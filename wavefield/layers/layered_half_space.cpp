#include "wavefield/layers/layered_half_space.hpp"

#include "base/require.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;

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
  require(layer.relaxing_share_p >= 0.0 && layer.relaxing_share_p <= 1.0,
          which + "share of the P-wave modulus that relaxes", layer.relaxing_share_p, "in [0, 1]");
}

} // namespace

double LayeredHalfSpace::thickness() const {
  double sum = 0.0;
  for (const Layer& layer : layers)
    sum += layer.thickness;
  return sum;
}

RayleighFactors rayleigh_factors(const Damping& damping, double ratio) {
  if (damping.model != DampingModel::rayleigh)
    return {};
  const double first = 2.0 * std::numbers::pi * damping.frequencies_hz[0];
  const double second = 2.0 * std::numbers::pi * damping.frequencies_hz[1];
  return {2.0 * ratio * first * second / (first + second), 2.0 * ratio / (first + second)};
}

MediumModuli::MediumModuli(const LayeredHalfSpace& profile, std::size_t index) : damping_(profile.damping) {
  const bool deep = index == profile.layers.size();
  const HalfSpace& below = profile.half_space;
  const Layer layer = deep ? Layer{.density = below.density,
                                   .vs = below.vs,
                                   .vp = below.vp,
                                   .damping = profile.half_space_damping}
                           : profile.layers[index];
  shear_ = {layer.density * layer.vs * layer.vs, layer.damping};
  p_wave_ = {layer.density * layer.vp * layer.vp, layer.damping_p.value_or(layer.damping)};
  if (damping_.model != DampingModel::constant)
    return;
  const materials::ConstantDamping constant{damping_.reference_hz, damping_.band};
  shear_.relaxation = materials::relaxation(constant, shear_.ratio);
  p_wave_.relaxation = materials::relaxation(constant, p_wave_.ratio).on_share(layer.relaxing_share_p);
}

ComplexModuli MediumModuli::at(Complex s) const {
  return {shear_.value * factor(shear_, s), p_wave_.value * factor(p_wave_, s)};
}

/// Complex over undamped modulus.
Complex MediumModuli::factor(const Modulus& modulus, Complex s) const {
  const double ratio = modulus.ratio;
  const double omega_0 = 2.0 * std::numbers::pi * damping_.reference_hz;
  switch (damping_.model) {
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
  case DampingModel::constant:
    return modulus.relaxation.factor(s);
  case DampingModel::rayleigh:
    return 1.0 + rayleigh_factors(damping_, ratio).beta * s;
  }
  throw std::logic_error("a damping model without a formula");
}

bool is_frequency_independent(DampingModel model) {
  return model == DampingModel::none || jumps_at_zero_frequency(model);
}

bool jumps_at_zero_frequency(DampingModel model) {
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
  case DampingModel::constant:
    return "constant";
  case DampingModel::rayleigh:
    return "rayleigh";
  }
  throw std::logic_error("a damping model without a name");
}

void validate(const LayeredHalfSpace& profile) {
  validate(profile.half_space);
  validate_ratio("half-space damping ratio", profile.half_space_damping, profile.damping.model);
  for (std::size_t i = 0; i < profile.layers.size(); ++i)
    validate(profile.layers[i], "layer " + std::to_string(i + 1) + " from the top: ", profile.damping.model);
  if (profile.damping.model == DampingModel::rayleigh) {
    const auto [first, second] = profile.damping.frequencies_hz;
    require_positive("first frequency of rayleigh damping", first, "Hz");
    require(second > first && std::isfinite(second), "second frequency of rayleigh damping", second,
            "above the first, " + shortest(first) + " Hz");
    require(profile.half_space_damping == 0.0, "half-space damping ratio", profile.half_space_damping,
            "0 under rayleigh damping, which is relative to the motion of undamped rock");
  } else if (!is_frequency_independent(profile.damping.model)) {
    require_positive("reference frequency of " + std::string(name(profile.damping.model)) + " damping",
                     profile.damping.reference_hz, "Hz");
  }
  if (profile.damping.model == DampingModel::constant)
    materials::validate({profile.damping.reference_hz, profile.damping.band});
}

} // namespace tremolo::wavefield
