#include "scene/keys/soil/keys_soil.hpp"

#include "materials/plastic/drucker_prager.hpp"
#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"
#include "scene/keys/soil/keys_law.hpp"
#include "scene/soils/soil_library.hpp"

namespace tremolo::scene {

namespace {

/// A key of the built-in curves.
Key darendeli(std::string_view name, std::string_view unit, std::string_view meaning,
              std::string_view fallback, Range range) {
  return {.name = name,
          .unit = unit,
          .meaning = meaning,
          .required = fallback.empty(),
          .fallback = fallback,
          .range = range,
          .when = {"curve", {"darendeli"}}};
}

/// What laws take besides numbers.
std::vector<Key> shape_keys() {
  const std::vector<std::string_view> all = {name(SoilModel::hyperbolic), name(SoilModel::mkz),
                                             name(SoilModel::gqh)};
  return {
      {.name = "cone",
       .type = Type::choice,
       .meaning = "In which test the circular cone has the angles: `triaxial_compression`, for which the "
                  "recommended "
                  "sets of `pdmy03` are made, far stronger in plane strain than the angle; "
                  "`triaxial_extension`; `plane_strain`.",
       .otherwise = "`plane_strain` of `drucker_prager`, `triaxial_compression` of `pdmy03`",
       .choices = all_words<materials::ConeMatch>(),
       .when = {"model", {name(SoilModel::drucker_prager), name(SoilModel::pdmy03)}}},
      {.name = "curve",
       .type = Type::text,
       .meaning =
           "G/G0 and damping against shear strain: `darendeli` (2001), or the name of a table "
           "`strain,modulus_reduction,damping`, relative to the case file. The backbone of "
           "`mkz` and `gqh` is fitted to it, and `eql` takes it as it is. In `pdmy03` G/G0 replaces the "
           "hyperbola that the surfaces share, and strength follows from it; in `multi_yield_clay` it "
           "does so up to s_u.",
       .otherwise = "the backbone given, a hyperbola of `pdmy03` and `multi_yield_clay`",
       .when = {"model",
                {name(SoilModel::mkz), name(SoilModel::gqh), name(SoilModel::multi_yield_clay),
                 name(SoilModel::pdmy03)}}},
      {.name = "theta",
       .type = Type::numbers,
       .unit = "1",
       .meaning = "theta1 to theta5 of the backbone of `gqh`, Groholski et al. (2016).",
       .otherwise = "fitted to `curve`",
       .count = 5,
       .form = "[theta1, theta2, theta3, theta4, theta5]",
       .when = {"model", {name(SoilModel::gqh)}}},
      {.name = "unloading",
       .type = Type::choice,
       .meaning =
           "Curves after a reversal: `masing`, the backbone doubled; `mrdf`, Phillips & Hashash (2009), with "
           "the share of that damping that `mrdf` has, or that fits the damping of `curve` above its least.",
       .fallback = name(Unloading::masing),
       .choices = all_words<Unloading>(),
       .when = {"model", all}},
      {.name = "mrdf",
       .type = Type::numbers,
       .unit = "1",
       .meaning = "Share F = p1 - p2 (1 - G/G0)^p3 of the damping of the Masing rules, G/G0 at the largest "
                  "strain so "
                  "far.",
       .otherwise = "fitted to `curve`",
       .count = 3,
       .form = "[p1, p2, p3]",
       .when = {"unloading", {name(Unloading::mrdf)}}},
      darendeli("plasticity_index", "%", "Plasticity index.", "", from_zero),
      darendeli("overconsolidation_ratio", "1", "Overconsolidation ratio.", "1", {.low = 1.0}),
      darendeli("mean_stress", "Pa", "Mean effective confining stress.", "", {.low = 100.0, .high = 1e8}),
      darendeli("excitation_hz", "Hz", "Frequency of loading.", "1", above_zero),
      darendeli("cycles", "1", "Number of cycles of loading.", "10", {.low = 1.0}),
      {.name = "post_shake",
       .type = Type::boolean,
       .meaning = "The sand has been shaken and reconsolidates: elastic stiffness reduced by F_sed.",
       .fallback = "false",
       .when = {"model", {name(SoilModel::pm4sand)}}},
  };
}

} // namespace

std::vector<Key> soil_keys() {
  std::vector<Key> keys = {
      {.name = library_key,
       .type = Type::text,
       .meaning = "Name of a soil of the library (`tremolo soiltest --library` lists them): what is not "
                  "given here is "
                  "as there.",
       .otherwise = "all is given here"},
      choice<SoilModel>(
          "model",
          "Constitutive law. `mohr_coulomb` softens with strain; `drucker_prager`: a circular cone; "
          "`multi_yield_clay`: undrained clay in total stress, nested von Mises surfaces. `hyperbolic` "
          "and `mkz`: hysteretic soil by the extended Masing "
          "rules, G/G0 = 1/(1 + beta (gamma/reference_strain)^exponent); `gqh`: the same with a given "
          "strength. `pm4sand`: sand that liquefies, "
          "PM4Sand 3.1. `pdmy03`: sand with cyclic mobility, pressure-dependent multi-yield, set 03.")};
  for (const auto& group : {law_keys(), shape_keys()})
    keys.insert(keys.end(), group.begin(), group.end());
  return keys;
}

} // namespace tremolo::scene
