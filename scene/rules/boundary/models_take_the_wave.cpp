#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/rules/free_field_limits.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

namespace tremolo::scene {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

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

/// A column under a motion within the ground ends where that motion is: at the top of the half-space.
bool ends_above_the_base(const Case& scene, SourceModel model, double surface,
                         const std::vector<Layer>& layers) {
  return scene.motion.kind == motion::MotionKind::within &&
         traits(model).within == WithinMotion::moves_base && scene.mesh.size > 0.0 &&
         scene.mesh.box.y_min < base_level(surface, layers) - 1e-6;
}

} // namespace

void models_take_the_wave(const Case& scene, Findings& findings) {
  if (!scene.boundary.takes_waves() || !findings.sound("motion.angle_deg") ||
      !findings.sound("motion.vertical") || !findings.sound("halfspace"))
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
    if (const auto why = refused_wave(scene, model, surface, layers); !why.empty())
      findings.add(path, why + other_ways(scene, model, surface, layers));
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
