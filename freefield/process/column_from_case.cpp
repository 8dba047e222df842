#include "freefield/process/column_from_case.hpp"
#include "scene/layers.hpp"

#include "freefield/fe_column.hpp"

#include <algorithm>

namespace tremolo::freefield {

namespace {

/// Share of central differences' stability limit that a column takes if the case names no step.
constexpr double fraction_of_limit = 0.8;

Profile profile_from_case(const scene::Case& scene, const scene::SourceProcess& source) {
  Profile profile{source.surface, {}, scene.halfspace};
  for (const scene::Layer& layer : scene::layers(scene, source))
    profile.layers.push_back({layer.thickness, layer.elastic, layer.damping});
  const double missing = profile.base_level() - scene.mesh.box.y_min;
  if (missing > 0.0)
    profile.layers.push_back({missing, scene.halfspace, 0.0});
  return profile;
}

Damping damping_from_case(const scene::Case& scene) {
  if (scene.damping.model == scene::DampingModel::rayleigh)
    return RayleighDamping{scene.damping.frequencies[0], scene.damping.frequencies[1]};
  return KelvinVoigtDamping{scene.damping.reference_hz.value_or(1.0)}; // without it no layer has a ratio
}

} // namespace

std::unique_ptr<Column> column_from_case(const scene::Case& scene, const scene::SourceProcess& source,
                                         const IncidentWave& incident) {
  const Profile profile = profile_from_case(scene, source);
  const double base = profile.base_level();
  FeColumnSettings settings;
  settings.max_element_size = scene.fe.element_size;
  settings.damping = damping_from_case(scene);
  settings.integrator = scene.fe.integrator == scene::Integrator::newmark ? Integrator::newmark
                                                                          : Integrator::central_difference;
  settings.time_step = scene.fe.dt
                           ? *scene.fe.dt
                           : fraction_of_limit * central_difference_limit(profile, settings.max_element_size,
                                                                          settings.damping);
  // At rest before the motion begins, and two steps before the shaking for the exchange to interpolate.
  settings.start_time = std::min(0.0, incident.begin(base)) - 2.0 * settings.time_step;
  return std::make_unique<FeColumn>(profile, settings,
                                    [&incident, base](double time) { return incident.velocity(base, time); });
}

} // namespace tremolo::freefield
