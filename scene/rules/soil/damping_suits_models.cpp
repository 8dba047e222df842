#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace tremolo::scene {

namespace {

std::string without_model(double ratio) {
  return fmt::format("'damping' = {} has no effect without a damping model; set [damping] model, e.g. to "
                     "\"kelvin_voigt\"",
                     ratio);
}

/// A ratio that stands in the file but has no law of frequency.
void ratios_have_model(const Case& scene, Findings& findings) {
  const auto check = [&](const std::vector<Layer>& layers, const std::string& name) {
    for (std::size_t i = 0; i < layers.size(); ++i)
      if (const auto path = fmt::format("{}[{}].damping", name, i);
          !layers[i].soil && layers[i].damping > 0.0 && findings.sound(path))
        findings.add(path, without_model(layers[i].damping));
  };
  for (const Soil& soil : scene.soils)
    if (const auto path = fmt::format("soil.{}.damping", soil.name);
        soil.damping > 0.0 && findings.sound(path))
      findings.add(path, without_model(soil.damping));
  check(scene.profile, "profile");
  check(scene.boundary.left.own_profile, "boundary.left.profile");
  check(scene.boundary.right.own_profile, "boundary.right.profile");
  if (scene.halfspace_damping > 0.0 && findings.sound("halfspace.damping"))
    findings.add("halfspace.damping", fmt::format("'damping' = {} has no effect without a damping model; set "
                                                  "[damping] model, e.g. to \"hysteretic\"",
                                                  scene.halfspace_damping));
}

/// `wave` knows its part in proportion to mass at vertical incidence, relative to the outcrop.
void rayleigh_suits_models(const Case& scene, std::span<const SourceModel> sources, Findings& findings) {
  bool to_outcrop = false;
  for (const SourceModel model : computed_models()) {
    if (std::ranges::find(sources, model) == sources.end())
      continue;
    to_outcrop = to_outcrop || traits(model).rayleigh == RayleighReference::outcrop;
    if (traits(model).rayleigh == RayleighReference::none)
      findings.add("damping.model",
                   fmt::format("model = \"rayleigh\" is for columns and \"wave\"; model \"{}\" knows "
                               "\"constant\", \"kelvin_voigt\", \"hysteretic\", \"shake\" and "
                               "\"kjartansson\"",
                               name(model)));
  }
  if (!to_outcrop)
    return;
  if (scene.halfspace_damping > 0.0)
    findings.add("damping.model", "model = \"rayleigh\" is relative to the motion of undamped rock: remove "
                                  "'damping' of [halfspace], or take another model");
  else if (scene.is_oblique())
    findings.add(
        "damping.model",
        fmt::format("model = \"rayleigh\" is known to \"wave\" at vertical incidence only, but [motion] "
                    "angle_deg = {}; take \"constant\" or \"kelvin_voigt\"",
                    scene.motion.angle_deg));
  else if (scene.motion.kind == motion::MotionKind::within)
    findings.add("damping.model",
                 "model = \"rayleigh\" is known to \"wave\" under incident and outcrop motions "
                 "only: under a motion within the ground columns have it relative to their rigid "
                 "base; take \"fe\", or \"constant\"");
}

} // namespace

void damping_suits_models(const Case& scene, Findings& findings) {
  if (!findings.sound("damping") || !findings.sound("damping.model"))
    return;
  const DampingModel model = scene.damping.model;
  if (const auto& band = scene.damping.band;
      band.lowest_hz >= band.highest_hz && findings.sound("damping.band"))
    return findings.add("damping.band",
                        fmt::format("'band' = [{}, {}] must rise", band.lowest_hz, band.highest_hz));
  if (model == DampingModel::none)
    return ratios_have_model(scene, findings);

  const auto& [sides, left, right, base] = scene.boundary;
  const std::array sources = {left.field.model, right.field.model, base.field.model};
  if (scene.halfspace_damping > 0.0 && std::ranges::any_of(sources, marched_in_time) &&
      findings.sound("halfspace.damping"))
    findings.add(
        "halfspace.damping",
        fmt::format("'damping' = {} of the half-space is known to models \"wave\" and \"eql\" only: a column "
                    "stands on an undamped one; remove it",
                    scene.halfspace_damping));
  const bool any_damped = damped(layers(scene, left)) || damped(layers(scene, right));
  if (model == DampingModel::rayleigh) {
    if (any_damped || scene.halfspace_damping > 0.0)
      rayleigh_suits_models(scene, sources, findings);
    return;
  }
  if (scene.damping.reference_hz || !findings.sound("damping.reference_hz"))
    return;
  const auto need = [&](const std::string& whose) {
    findings.add("damping.reference_hz",
                 fmt::format("missing 'reference_hz': at which frequency {} has its ratio", whose));
  };
  if (model == DampingModel::kelvin_voigt || model == DampingModel::kjartansson ||
      model == DampingModel::constant)
    need(fmt::format("\"{}\" damping", name(model)));
  else if (any_damped && std::ranges::any_of(sources, marched_in_time))
    need("the Kelvin-Voigt damping of a column, which has no other here,");
  else if (domain_is_damped(scene))
    need("the Kelvin-Voigt damping of the domain, which has no other,");
}

} // namespace tremolo::scene
