#include "scene/rules/free_field_limits.hpp"

#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/wave/slowness.hpp"
#include "scene/soils/viscous_damping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace tremolo::scene {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// The material in which a wave is fastest, and its speed.
struct Fastest {
  double speed = 0.0; ///< m/s
  std::string place;
};

/// c_1, m/s: of P waves, in two phases without drag where water flows, and of soil with constant damping
/// while nothing has relaxed.
double fast_speed(const Case& scene, const Layer& layer) {
  const double unrelaxed = relaxation(scene.damping, layer.damping).unrelaxed();
  const double alone = layer.elastic.p_wave_speed();
  if (!layer.wet)
    return alone * std::sqrt(unrelaxed);
  const Soil& soil = scene.soils[*layer.soil];
  const double modulus = materials::elasticity(soil.law).p_modulus();
  if (soil.pores->drainage == materials::Drainage::coupled)
    return materials::saturated_speeds(unrelaxed * modulus, *soil.pores, scene.water->fluid).fast;
  return std::sqrt(alone * alone + (unrelaxed - 1.0) * modulus / layer.elastic.density);
}

/// At a horizontal slowness of 1/c_1 or more the column's initial-value problem is ill posed.
Fastest fastest(const Case& scene, const std::vector<Layer>& layers) {
  Fastest fastest{scene.halfspace.p_wave_speed(), "the half-space"};
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (const double speed = fast_speed(scene, layers[i]); speed > fastest.speed) {
      fastest = {speed, fmt::format("layer {} from the top", i + 1)};
      if (layers[i].soil)
        fastest.place += fmt::format(", {}soil '{}'", layers[i].wet ? "saturated " : "",
                                     scene.soils[*layers[i].soil].name);
    }
  return fastest;
}

std::string refused_angle(const Case& scene, const MotionInput& wave, SourceModel model,
                          const std::vector<Layer>& layers) {
  const double angle = wave.angle_deg;
  if (traits(model).incidence == Incidence::vertical && angle != 0.0)
    return fmt::format("model = \"{}\" knows vertical incidence only, but [{}] angle_deg = {}", name(model),
                       wave.path, angle);
  if (traits(model).incidence != Incidence::below_critical || angle == 0.0)
    return {};
  const double incident = incident_speed(scene, wave);
  const auto [speed, place] = fastest(scene, layers);
  if (std::sin(angle * degree) * speed < incident)
    return {};
  return fmt::format(
      "model = \"{}\" is possible below {:.2f} degrees only, the critical angle of {} (P waves of "
      "{:.4g} m/s), but [{}] angle_deg = {}",
      name(model), std::asin(incident / speed) / degree, place, speed, wave.path, angle);
}

/// Waves of one horizontal slowness alone make a field that is the same along x, only later, as columns have
/// it; and the equivalent-linear iteration knows the shear strain of the SV wave alone, which is all there is
/// where the P wave comes up vertically.
std::string refused_pair(const Case& scene, SourceModel model) {
  if (!scene.vertical)
    return {};
  const double angle = scene.vertical->angle_deg;
  if (traits(model).soil == SoilTreatment::equivalent_linear && angle != 0.0)
    return fmt::format("model = \"{}\" iterates on the shear strain of the SV wave, and the P wave of "
                       "[motion.vertical] shears the ground too at angle_deg = {}: give it angle_deg = 0",
                       name(model), angle);
  const double slowness = slowness_x(scene, scene.motion);
  constexpr double same_slowness = 1e-3;
  if (!marched_in_time(model) ||
      std::abs(slowness_x(scene, *scene.vertical) - slowness) <= same_slowness * slowness)
    return {};
  const double sine = slowness * scene.halfspace.p_wave_speed();
  return fmt::format("model = \"{}\" takes waves of one speed along x, but [motion] at {} degrees and "
                     "[motion.vertical] at {} degrees have two{}",
                     name(model), scene.motion.angle_deg, angle,
                     sine < 1.0 ? fmt::format(": the P wave beside this SV wave has angle_deg = {:.4g}",
                                              std::asin(sine) / degree)
                                : "");
}

/// `wave` takes a motion within the ground up again by division, which undamped layers have no answer for.
std::string refused_kind(const Case& scene, SourceModel model, const std::vector<Layer>& layers) {
  if (scene.motion.kind != motion::MotionKind::within)
    return {};
  if (traits(model).computed && traits(model).within == WithinMotion::refuses)
    return fmt::format("model = \"{}\" takes an incident or outcrop motion, not one within the ground",
                       name(model));
  if (traits(model).within == WithinMotion::divides && !layers.empty() && !damped(layers))
    return fmt::format("model = \"{}\" under a motion within the ground needs damped layers: undamped ones "
                       "resonate on it without end; give them 'damping'",
                       name(model));
  return {};
}

/// A column of the domain's particles ends where a particle does.
std::string refused_surface(const Case& scene, SourceModel model, double surface) {
  if (!traits(model).of_domain_cells || !(scene.mesh.size > 0.0))
    return {};
  const double size = scene.mesh.particle_size();
  const double particles = (surface - scene.mesh.box.y_min) / size;
  if (particles >= 1.0 && std::abs(particles - std::round(particles)) < 1e-6)
    return {};
  return fmt::format(
      "model = \"{}\" stacks particles of {} m from the base of the model, y = {}, to the surface, y = "
      "{}: their distance must be a multiple of it",
      name(model), size, scene.mesh.box.y_min, surface);
}

/// Whether shear stress follows from shear strain alone.
bool in_one_shear(const materials::Law& law) {
  return materials::traits(law).response == materials::Response::elastic || materials::shear_backbone(law);
}

/// Whether `damping_suits_models` refuses the damping.
bool refused_damping(const Case& scene, SourceModel model, const std::vector<Layer>& layers) {
  if (in_frequency_domain(model))
    return scene.damping.model == DampingModel::rayleigh && (damped(layers) || scene.halfspace_damping > 0.0);
  return scene.halfspace_damping > 0.0;
}

bool takes(const Case& scene, SourceModel model, double surface, const std::vector<Layer>& layers) {
  return refused_wave(scene, model, surface, layers).empty() && refused_soil(scene, model, layers).empty() &&
         !refused_damping(scene, model, layers) && (!traits(model).of_domain_cells || scene.mesh.size > 0.0);
}

/// "wave", "fe" or "eql"
std::string listed(const std::vector<SourceModel>& models) {
  std::string text;
  for (std::size_t i = 0; i < models.size(); ++i)
    text += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 == models.size() ? " or " : ", ", name(models[i]));
  return text;
}

std::vector<SourceModel> all_that_take(const Case& scene, double surface, const std::vector<Layer>& layers) {
  std::vector<SourceModel> models;
  for (const SourceModel model : computed_models())
    if (takes(scene, model, surface, layers))
      models.push_back(model);
  return models;
}

/// Whether the frequency domain takes a layer that yields as linear elastic.
bool is_linearised(const Case& scene, const std::vector<Layer>& layers) {
  return std::ranges::any_of(layers, [&](const Layer& layer) {
    return layer.soil && !scene.soils[*layer.soil].curves &&
           materials::traits(scene.soils[*layer.soil].law).response != materials::Response::elastic;
  });
}

} // namespace

std::string refused_wave(const Case& scene, SourceModel model, double surface,
                         const std::vector<Layer>& layers) {
  for (const MotionInput* wave : scene.plane_waves())
    if (std::string why = refused_angle(scene, *wave, model, layers); !why.empty())
      return why;
  for (std::string why : {refused_pair(scene, model), refused_kind(scene, model, layers),
                          refused_surface(scene, model, surface)})
    if (!why.empty())
      return why;
  return {};
}

std::string refused_soil(const Case& scene, SourceModel model, const std::vector<Layer>& layers) {
  if (!traits(model).laws_of_one_shear)
    return {};
  for (const Layer& layer : layers) {
    if (!layer.soil)
      continue;
    const Soil& soil = scene.soils[*layer.soil];
    if (materials::traits(soil.law).remembers_initial_stress)
      return fmt::format("model = \"{}\" gives its soil no memory of the geostatic stress, with which {} "
                         "(soil '{}') begins",
                         name(model), materials::name(soil.law), soil.name);
    if (!in_one_shear(soil.column_law))
      return fmt::format("model = \"{}\" takes linear and hysteretic soil, but soil '{}' is {}", name(model),
                         soil.name, materials::name(soil.law));
  }
  return {};
}

std::string other_ways(const Case& scene, SourceModel model, double surface,
                       const std::vector<Layer>& layers) {
  std::string text;
  const bool yields = is_linearised(scene, layers);
  std::vector<SourceModel> models = all_that_take(scene, surface, layers);
  if (yields && !std::ranges::all_of(models, in_frequency_domain))
    std::erase_if(models, in_frequency_domain); // others know that it yields
  if (!models.empty()) {
    text = "; use model = " + listed(models);
    if (yields && in_frequency_domain(models.front()))
      text += fmt::format(", which take{} soil that yields as linear elastic", models.size() == 1 ? "s" : "");
  }
  if (!scene.is_oblique())
    return text;
  Case upright = scene;
  upright.motion.angle_deg = 0.0;
  if (upright.vertical)
    upright.vertical->angle_deg = 0.0;
  std::vector<SourceModel> others = all_that_take(upright, surface, layers);
  std::erase_if(others, [&](SourceModel other) {
    return in_frequency_domain(other) || std::ranges::find(models, other) != models.end();
  });
  if (others.empty())
    return text;
  text += text.empty() ? "; use angle_deg = 0" : ", or angle_deg = 0";
  if (std::ranges::find(others, model) == others.end())
    text += " with model = " + listed(others);
  return text;
}

} // namespace tremolo::scene
