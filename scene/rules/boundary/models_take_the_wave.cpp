#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace tremolo::scene {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// The largest P-wave speed that an oblique column meets, m/s. At a horizontal slowness of 1/c_p or more the
/// column's initial-value problem is ill posed.
double fastest(const Case& scene, const std::vector<Layer>& layers) {
  double speed = scene.halfspace.p_wave_speed();
  for (const Layer& layer : layers)
    speed = std::max(speed, layer.elastic.p_wave_speed());
  return speed;
}

std::string refused_angle(const Case& scene, SourceModel model, const std::vector<Layer>& layers) {
  const double angle = scene.motion.angle_deg;
  if ((model == SourceModel::fe || model == SourceModel::ode || model == SourceModel::mpm) && angle != 0.0)
    return fmt::format(
        "model = \"{}\" knows vertical incidence only, but [motion] angle_deg = {}; use model = "
        "\"wave\", \"oblique\" or \"eql\", or angle_deg = 0",
        name(model), angle);
  if (model != SourceModel::oblique)
    return {};
  const double incident =
      scene.motion.wave == Wave::sv ? scene.halfspace.s_wave_speed() : scene.halfspace.p_wave_speed();
  const double speed = fastest(scene, layers);
  if (std::sin(angle * degree) * speed < incident)
    return {};
  return fmt::format(
      "model = \"oblique\" is possible below {:.2f} degrees only, where no P wave of this profile is "
      "beyond its critical angle, but [motion] angle_deg = {}; use model = \"wave\"",
      std::asin(incident / speed) / degree, angle);
}

/// Beyond the critical angle of the half-space the reflected P wave is evanescent, and an outcrop's motion is
/// no multiple of the incident one.
void outcrop_has_a_factor(const Case& scene, Findings& findings) {
  if (scene.motion.kind != motion::MotionKind::outcrop || scene.motion.wave != Wave::sv)
    return;
  const double critical = std::asin(scene.halfspace.s_wave_speed() / scene.halfspace.p_wave_speed()) / degree;
  if (scene.motion.angle_deg >= critical)
    findings.add(
        "motion.kind",
        fmt::format("kind = \"outcrop\" at {} degrees, beyond the critical angle of {:.2f} degrees: no "
                    "incident wave follows from the outcrop's motion there; give an incident motion",
                    scene.motion.angle_deg, critical));
}

std::string refused_kind(const Case& scene, SourceModel model) {
  if (scene.motion.kind != motion::MotionKind::within)
    return {};
  if (model == SourceModel::eql || model == SourceModel::oblique || model == SourceModel::mpm)
    return fmt::format(
        "model = \"{}\" takes an incident or outcrop motion, not one within the ground; use model = "
        "\"fe\", \"ode\" or \"wave\"",
        name(model));
  return {};
}

/// A column of the domain's particles ends where a particle does.
std::string refused_surface(const Case& scene, SourceModel model, double surface) {
  if (model != SourceModel::mpm || !(scene.mesh.size > 0.0))
    return {};
  const double size = scene.mesh.particle_size();
  const double particles = (surface - scene.mesh.box.y_min) / size;
  if (particles >= 1.0 && std::abs(particles - std::round(particles)) < 1e-6)
    return {};
  return fmt::format(
      "model = \"mpm\" stacks particles of {} m from the base of the model, y = {}, to the surface, y = "
      "{}: their distance must be a multiple of it",
      size, scene.mesh.box.y_min, surface);
}

/// A column under a motion within the ground ends where that motion is: at the top of the half-space.
bool ends_above_the_base(const Case& scene, SourceModel model, double surface,
                         const std::vector<Layer>& layers) {
  const bool column = model == SourceModel::fe || model == SourceModel::ode;
  return scene.motion.kind == motion::MotionKind::within && column && scene.mesh.size > 0.0 &&
         scene.mesh.box.y_min < base_level(surface, layers) - 1e-6;
}

} // namespace

void models_take_the_wave(const Case& scene, Findings& findings) {
  if (scene.boundary.has_shaking_table() || !findings.sound("motion.angle_deg") ||
      !findings.sound("halfspace"))
    return;
  if (findings.sound("motion.kind"))
    outcrop_has_a_factor(scene, findings);
  const auto check = [&](SourceModel model, double surface, const std::vector<Layer>& layers,
                         const std::string& path) {
    if (!findings.sound(path))
      return;
    if (findings.sound("mesh.box") && ends_above_the_base(scene, model, surface, layers))
      findings.add(
          path,
          fmt::format("model = \"{}\" under a motion within the ground ends at the top of the half-space, "
                      "y = {}, but [mesh] box reaches down to y = {}; both must agree",
                      name(model), base_level(surface, layers), scene.mesh.box.y_min));
    for (const std::string& why : {refused_angle(scene, model, layers), refused_kind(scene, model),
                                   refused_surface(scene, model, surface)})
      if (!why.empty())
        findings.add(path, why);
  };
  const auto& [sides, left, right, base] = scene.boundary;
  if (scene.boundary.has_lateral_fields()) {
    check(left.field.model, left.surface, layers(scene, left), "boundary.left.model");
    check(right.field.model, right.surface, layers(scene, right), "boundary.right.model");
  }
  check(base.field.model, left.surface, layers(scene, left), "boundary.base.model");
  if (base.form == BaseForm::blended && findings.sound("boundary.base.model"))
    check(base.field.model, right.surface, layers(scene, right), "boundary.base.model");
  if (base.form == BaseForm::blended && base.field.model == SourceModel::recording)
    findings.add(
        "boundary.base.model",
        "model = \"recording\" serves one free field again, but form = \"blended\" needs those of both "
        "sides; use a model that computes them, or form = \"incident\"");
}

} // namespace tremolo::scene
