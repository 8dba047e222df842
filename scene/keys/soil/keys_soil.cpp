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

<<<<<<< HEAD
Condition mohr_coulomb() {
  return {"model", {name(SoilModel::mohr_coulomb)}};
}

Key strength(std::string_view name, std::string_view unit, std::string_view meaning, Range range,
             std::string_view fallback = {}) {
  return {.name = name,
          .unit = unit,
          .meaning = meaning,
          .required = fallback.empty(),
          .fallback = fallback,
          .range = range,
          .when = mohr_coulomb()};
}

/// The elastic constants, of the models that are given them.
std::vector<Key> soil_elastic_keys() {
  const std::vector<std::string_view> elastic = {name(SoilModel::linear_elastic),
                                                 name(SoilModel::mohr_coulomb),
                                                 name(SoilModel::drucker_prager),
                                                 name(SoilModel::multi_yield_clay),
                                                 name(SoilModel::hyperbolic),
                                                 name(SoilModel::mkz),
                                                 name(SoilModel::gqh)};
  auto keys = elastic_keys();
  for (Key& key : keys) {
    if (key.name == "density") {
      key.required = false;
      key.otherwise = "that of the recommended set of `pdmy03`; other models need it";
      continue;
    }
    key.when = {"model", elastic};
    if (key.name == "poisson") {
      key.when.values.emplace_back(name(SoilModel::pm4sand));
      key.otherwise = "`vs` and `vp`; 0.3 of `pm4sand`";
      key.meaning = "Poisson's ratio; together with `young`, of `pm4sand` alone.";
    }
  }
  return keys;
}

std::vector<Key> mohr_coulomb_keys() {
  return {
      strength("cohesion_peak", "Pa", "Cohesion before softening.", not_negative),
      strength("cohesion_residual", "Pa", "Cohesion after softening, at most the peak.", not_negative),
      strength("friction_peak_deg", "degrees", "Friction angle before softening.", angle),
      strength("friction_residual_deg", "degrees", "Friction angle after softening, at most the peak.",
               angle),
      strength("dilation_peak_deg", "degrees", "Dilation angle before softening, at most the friction angle.",
               angle, "0"),
      strength("dilation_residual_deg", "degrees", "Dilation angle after softening.", angle, "0"),
      strength(
          "softening", "1",
          "Softening coefficient eta: c and the angles decay from peak to residual with exp(-eta e), e the "
          "equivalent plastic deviatoric strain. 0 keeps the peak.",
          not_negative),
      {.name = "tension_cutoff",
       .unit = "Pa",
       .meaning = "Largest tensile stress.",
       .otherwise = "the apex c cot(phi)",
       .range = not_negative,
       .when = mohr_coulomb()},
      {.name = "reference_size",
       .unit = "m",
       .meaning = "Cell size h_ref for which `softening` holds: eta is scaled by h/h_ref, so that the work "
                  "of a shear band "
                  "does not depend on the mesh.",
       .otherwise = "needed where `softening` > 0",
       .range = positive,
       .when = mohr_coulomb()},
  };
}

/// The keys of cones and surfaces that more than one model has.
std::vector<Key> surface_keys() {
  const std::vector<std::string_view> cones = {name(SoilModel::drucker_prager), name(SoilModel::pdmy03)};
  return {
      {.name = "cohesion",
       .unit = "Pa",
       .meaning = "Cohesion.",
       .required = true,
       .range = not_negative,
       .when = {"model", {name(SoilModel::drucker_prager)}}},
      {.name = "friction_deg",
       .unit = "degrees",
       .meaning =
           "Friction angle, in the test that `cone` names. `drucker_prager` needs it; of `pdmy03` 1 to 65.",
       .otherwise = "that of the recommended set of `pdmy03`",
       .range = angle,
       .when = {"model", cones}},
      {.name = "dilation_deg",
       .unit = "degrees",
       .meaning = "Dilation angle, at most the friction angle.",
       .fallback = "0",
       .range = angle,
       .when = {"model", {name(SoilModel::drucker_prager)}}},
=======
/// What laws take besides numbers.
std::vector<Key> shape_keys() {
  const std::vector<std::string_view> all = {name(SoilModel::hyperbolic), name(SoilModel::mkz),
                                             name(SoilModel::gqh)};
  return {
>>>>>>> 4719851b (Laws own their keys: name, unit, meaning, range and default of a parameter stand once)
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
