#pragma once

#include "scene/case.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene {

/// Angles of incidence that a model takes.
enum class Incidence {
  any,            ///< any at which there is an incident wave
  below_critical, ///< below the first critical angle of its ground
  vertical
};

/// How a model treats a motion given within the ground.
enum class WithinMotion {
  moves_base, ///< its base is rigid there and moves as the motion says: it ends at the top of the half-space
  divides,    ///< divides by the transfer function, which damped layers alone allow
  refuses
};

/// How a model treats soil that yields.
enum class SoilTreatment {
  linear,
  equivalent_linear, ///< with moduli and damping of the strain that an iteration finds
  by_law             ///< as its constitutive law says
};

/// What Rayleigh's damping in proportion to mass is relative to.
enum class RayleighReference {
  rigid_base, ///< the motion of the column's base
  outcrop,    ///< the motion of undamped rock, which is known at vertical incidence
  none        ///< the model has no such damping
};

/// Properties and inputs of a free-field model.
struct FreeFieldTraits {
  SourceModel model;
  std::string_view program;     ///< that serves it; empty for one of the user's own
  bool computed = false;        ///< from the ground of the case file, as `column` and `swap` do
  bool marched_in_time = false; ///< if computed; otherwise it is in the frequency domain
  Incidence incidence = Incidence::any;
  WithinMotion within = WithinMotion::refuses;
  bool effective_stress = false; ///< begins with the stress of its weight and knows pore pressure
  SoilTreatment soil = SoilTreatment::linear;
  bool laws_of_one_shear = false; ///< takes only laws whose shear stress follows from shear strain alone
  RayleighReference rayleigh = RayleighReference::none;
  bool of_domain_cells = false;   ///< its elements are cells of the domain, with the domain's kernel
  std::string_view elements = ""; ///< the key of their length, if it is marched in time
  double (*element_size)(const Case& scene) = nullptr; ///< that length, m
  bool from_outside = false; ///< its motion is recorded or served by others; the case does not say it
};

inline constexpr std::array free_field_traits = {
    FreeFieldTraits{.model = SourceModel::wave,
                    .program = "tremolo-wave",
                    .computed = true,
                    .within = WithinMotion::divides,
                    .rayleigh = RayleighReference::outcrop},
    FreeFieldTraits{.model = SourceModel::fe,
                    .program = "tremolo-column",
                    .computed = true,
                    .marched_in_time = true,
                    .incidence = Incidence::below_critical,
                    .within = WithinMotion::moves_base,
                    .effective_stress = true,
                    .soil = SoilTreatment::by_law,
                    .rayleigh = RayleighReference::rigid_base,
                    .elements = "fe.element_size",
                    .element_size = [](const Case& scene) { return scene.fe.element_size; }},
    FreeFieldTraits{.model = SourceModel::ode,
                    .program = "tremolo-column",
                    .computed = true,
                    .marched_in_time = true,
                    .incidence = Incidence::vertical,
                    .within = WithinMotion::moves_base,
                    .soil = SoilTreatment::by_law,
                    .laws_of_one_shear = true,
                    .rayleigh = RayleighReference::rigid_base,
                    .elements = "ode.cell_size",
                    .element_size = [](const Case& scene) { return scene.ode.cell_size; }},
    FreeFieldTraits{.model = SourceModel::eql,
                    .program = "tremolo-wave",
                    .computed = true,
                    .soil = SoilTreatment::equivalent_linear},
    FreeFieldTraits{.model = SourceModel::mpm,
                    .program = "tremolo-domain",
                    .computed = true,
                    .marched_in_time = true,
                    .incidence = Incidence::vertical,
                    .effective_stress = true,
                    .soil = SoilTreatment::by_law,
                    .rayleigh = RayleighReference::rigid_base,
                    .of_domain_cells = true,
                    .elements = "mesh.size",
                    .element_size = [](const Case& scene) { return scene.mesh.size; }},
    FreeFieldTraits{.model = SourceModel::recording, .program = "tremolo-recording", .from_outside = true},
    FreeFieldTraits{.model = SourceModel::external, .program = "", .from_outside = true},
    FreeFieldTraits{.model = SourceModel::shaking_table, .program = "tremolo-wave"}};

constexpr const FreeFieldTraits& traits(SourceModel model) {
  return *std::ranges::find(free_field_traits, model, &FreeFieldTraits::model);
}

constexpr bool marched_in_time(SourceModel model) {
  return traits(model).marched_in_time;
}

constexpr bool in_frequency_domain(SourceModel model) {
  return traits(model).computed && !traits(model).marched_in_time;
}

/// The models that are computed from the ground of the case file.
inline std::vector<SourceModel> computed_models() {
  std::vector<SourceModel> models;
  for (const FreeFieldTraits& one : free_field_traits)
    if (one.computed)
      models.push_back(one.model);
  return models;
}

inline std::vector<std::string> names_of_computed_models() {
  std::vector<std::string> names;
  for (const SourceModel model : computed_models())
    names.emplace_back(name(model));
  return names;
}

/// @param word  one of names_of_computed_models()
inline SourceModel computed_model(std::string_view word) {
  const auto models = computed_models();
  return *std::ranges::find(models, word, [](SourceModel model) { return name(model); });
}

/// The models that --models names, in its order.
/// @param words  of names_of_computed_models()
/// @throws std::runtime_error where one is named twice
inline std::vector<SourceModel> computed_models(const std::vector<std::string>& words) {
  std::vector<SourceModel> models;
  for (const std::string& word : words) {
    if (std::ranges::count(words, word) > 1)
      throw std::runtime_error("--models: '" + word + "' is named twice");
    models.push_back(computed_model(word));
  }
  return models;
}

} // namespace tremolo::scene
