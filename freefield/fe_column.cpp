#include "freefield/fe_column.hpp"

#include "freefield/require.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::freefield {
namespace {

enum class Polarisation { shear, dilation };

double modulus(const materials::Elasticity& soil, Polarisation polarisation) {
  return polarisation == Polarisation::shear ? soil.shear_modulus() : soil.p_modulus();
}

double impedance(const materials::Elasticity& soil, Polarisation polarisation) {
  return std::sqrt(soil.density * modulus(soil, polarisation));
}

std::vector<ScalarElement> elements(const Profile& profile, const ColumnMesh& mesh, const Damping& damping,
                                    Polarisation polarisation) {
  std::vector<ScalarElement> elements;
  elements.reserve(mesh.elements());
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const Layer& layer = profile.layers[mesh.element_layer[e]];
    const DampingCoefficients c = coefficients(damping, layer.damping_ratio);
    elements.push_back(
        {mesh.length(e), layer.soil.density, modulus(layer.soil, polarisation), c.alpha, c.beta});
  }
  return elements;
}

/// Checks what the mesh and the scalar columns are about to be built from.
const Profile& checked(const Profile& profile, const Damping& damping) {
  validate(profile);
  const auto is_damped = [](const Layer& layer) { return layer.damping_ratio > 0.0; };
  if (std::any_of(profile.layers.begin(), profile.layers.end(), is_damped)) {
    validate(damping);
  }
  return profile;
}

const FeColumnSettings& checked(const FeColumnSettings& settings) {
  require(settings.time_step > 0.0 && std::isfinite(settings.time_step), "time step of the column",
          settings.time_step, "positive, in s");
  require(std::isfinite(settings.start_time), "start time of the column", settings.start_time, "finite");
  return settings;
}

} // namespace

double central_difference_limit(const Profile& profile, double max_element_size, const Damping& damping) {
  const ColumnMesh mesh = mesh_profile(checked(profile, damping), max_element_size);
  return std::min(central_difference_limit(elements(profile, mesh, damping, Polarisation::shear)),
                  central_difference_limit(elements(profile, mesh, damping, Polarisation::dilation)));
}

FeColumn::FeColumn(const Profile& profile, const FeColumnSettings& settings, InputVelocity input)
    : settings_(checked(settings)),
      mesh_(mesh_profile(checked(profile, settings.damping), settings.max_element_size)),
      input_(std::move(input)),
      shear_(elements(profile, mesh_, settings.damping, Polarisation::shear),
             impedance(profile.half_space, Polarisation::shear), settings.time_step, settings.integrator),
      dilation_(elements(profile, mesh_, settings.damping, Polarisation::dilation),
                impedance(profile.half_space, Polarisation::dilation), settings.time_step,
                settings.integrator) {
  if (!input_) {
    throw std::invalid_argument("the column has no input motion");
  }
  lateral_ratio_.reserve(mesh_.elements());
  for (const std::size_t layer : mesh_.element_layer) {
    lateral_ratio_.push_back(profile.layers[layer].soil.lame() / profile.layers[layer].soil.p_modulus());
  }
}

double FeColumn::time() const {
  return settings_.start_time + static_cast<double>(steps_) * settings_.time_step;
}

void FeColumn::step() {
  ++steps_;
  const Velocity incident = input_(time());
  shear_.step(incident.x);
  dilation_.step(incident.y);
}

void FeColumn::sample(std::span<const double> y, std::span<ColumnSample> samples) const {
  if (y.size() != samples.size()) {
    throw std::invalid_argument("number of samples is " + std::to_string(samples.size()) +
                                ", must be that of the levels, " + std::to_string(y.size()));
  }
  for (std::size_t i = 0; i < y.size(); ++i) {
    const auto [element, fraction] = mesh_.at(y[i]);
    const ScalarSample x = shear_.sample(element, fraction);
    const ScalarSample v = dilation_.sample(element, fraction);
    samples[i] = {.vx = x.velocity,
                  .vy = v.velocity,
                  .sxx = lateral_ratio_[element] * v.traction,
                  .syy = v.traction,
                  .sxy = x.traction,
                  .vx_rate = x.acceleration,
                  .vy_rate = v.acceleration,
                  .sxx_rate = lateral_ratio_[element] * v.traction_rate,
                  .syy_rate = v.traction_rate,
                  .sxy_rate = x.traction_rate};
  }
}

ColumnEnergy FeColumn::energy() const {
  const ColumnEnergy x = shear_.energy();
  const ColumnEnergy y = dilation_.energy();
  return {x.kinetic + y.kinetic, x.strain + y.strain, x.damping + y.damping, x.base_work + y.base_work};
}

} // namespace tremolo::freefield
