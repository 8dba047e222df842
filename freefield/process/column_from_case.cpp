#include "freefield/process/column_from_case.hpp"

#include "freefield/fe_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tremolo::freefield {

namespace {

/// Share of central differences' stability limit that a column takes if the case names no step.
constexpr double fraction_of_limit = 0.8;

Profile profile_from_case(const scene::Case& scene, const scene::SourceProcess& source) {
  Profile profile{source.surface, {}, scene.halfspace};
  for (const scene::Layer& layer : scene.profile)
    profile.layers.push_back({layer.thickness, layer.elastic, layer.damping_ratio});
  const double model_base = scene.mesh.box.y_min;
  const double missing = profile.base_level() - model_base;
  const bool serves_incident =
      std::any_of(source.serves.begin(), source.serves.end(),
                  [](const scene::Served& served) { return served.field == scene::BaseForm::incident; });
  if (missing < 0.0 && serves_incident)
    throw std::invalid_argument(fmt::format(
        "the base of the model, y = {:.6g} m, lies within the layers of [[profile]], which reach to y = "
        "{:.6g} m; base form \"incident\" needs it in the half-space",
        model_base, profile.base_level()));
  if (missing > 0.0)
    profile.layers.push_back({missing, scene.halfspace, 0.0});
  return profile;
}

Damping damping_from_case(const scene::Case& scene) {
  if (const auto* rayleigh = std::get_if<scene::RayleighDamping>(&scene.damping))
    return RayleighDamping{rayleigh->first_frequency, rayleigh->second_frequency};
  if (const auto* kelvin_voigt = std::get_if<scene::KelvinVoigtDamping>(&scene.damping))
    return KelvinVoigtDamping{kelvin_voigt->reference_frequency};
  return KelvinVoigtDamping{1.0}; // no layer has a damping ratio then
}

} // namespace

std::unique_ptr<Column> column_from_case(const scene::Case& scene, const scene::SourceProcess& source,
                                         const IncidentWave& incident) {
  const Profile profile = profile_from_case(scene, source);
  const double base = profile.base_level();
  FeColumnSettings settings;
  settings.max_element_size = scene.column.element_size;
  settings.damping = damping_from_case(scene);
  settings.integrator = scene.column.integrator == scene::Integrator::newmark
                            ? Integrator::newmark
                            : Integrator::central_difference;
  settings.time_step = scene.column.dt
                           ? *scene.column.dt
                           : fraction_of_limit * central_difference_limit(profile, settings.max_element_size,
                                                                          settings.damping);
  // At rest before the motion begins, and two steps before the shaking for the exchange to interpolate.
  settings.start_time = std::min(0.0, incident.begin(base)) - 2.0 * settings.time_step;
  return std::make_unique<FeColumn>(profile, settings,
                                    [&incident, base](double time) { return incident.velocity(base, time); });
}

} // namespace tremolo::freefield
