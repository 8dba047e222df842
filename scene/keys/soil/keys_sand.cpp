// Keys of the laws for sand that liquefies. What a user always has to think of has a name in words; the
// others have the symbols of their reports, by which everyone knows them.

#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"
#include "scene/keys/soil/keys_soil.hpp"

namespace tremolo::scene {

namespace {

/// One for which the law, or the soil's recommended set, has a value of its own.
Key optional(std::vector<std::string_view> models, std::string_view name, std::string_view unit,
             std::string_view meaning, std::string_view otherwise, Range range) {
  return {.name = name,
          .unit = unit,
          .meaning = meaning,
          .otherwise = otherwise,
          .range = range,
          .when = {"model", std::move(models)}};
}

// The ranges are those that the laws enforce.
constexpr Range density_range = {.low = 0.05, .high = 1.2};
constexpr Range coefficient = {.low = 0.0, .high = 10.0};

std::vector<Key> common_keys() {
  const std::vector<std::string_view> both = {scene::name(SoilModel::pm4sand),
                                              scene::name(SoilModel::pdmy03)};
  return {
      optional(both, "relative_density", "1",
               "Relative density D_R, a fraction. `pm4sand` needs it: apparent. With `pdmy03` it names a "
               "recommended set: 0.33, 0.57, 0.74 or 0.87; between them there is none, and none is guessed.",
               "all keys of `pdmy03` are needed", density_range),
      optional(both, "atmospheric_pressure", "Pa", "Atmospheric pressure of the formulas.",
               "101.3e3 of `pm4sand`, 101e3 of `pdmy03`", {.low = 1.0, .high = 1e9}),
  };
}

std::vector<Key> pm4sand_keys() {
  const auto need = [](std::string_view name, std::string_view meaning, Range range) {
    return Key{.name = name,
               .unit = "1",
               .meaning = meaning,
               .required = true,
               .range = range,
               .when = {"model", {scene::name(SoilModel::pm4sand)}}};
  };
  const auto may = [](std::string_view name, std::string_view unit, std::string_view meaning,
                      std::string_view otherwise, Range range) {
    return optional({scene::name(SoilModel::pm4sand)}, name, unit, meaning, otherwise, range);
  };
  return {
      need("shear_modulus_coefficient",
           "G_o of G = G_o p_A sqrt(p/p_A); 167 sqrt(46 D_R^2 + 2.5) where nothing is measured.", positive),
      need("contraction_rate",
           "h_po, fitted last, to the cyclic strength: `tremolo calibrate`. Larger is stronger.",
           {.low = 1e-6, .high = 1e6}),
      may("e_max", "1", "Largest void ratio.", "0.8", {.low = 0.01, .high = 10.0}),
      may("e_min", "1", "Smallest void ratio.", "0.5", coefficient),
      may("n_b", "1", "Bounding surface: M_b = M exp(-n_b xi_R).", "0.5", coefficient),
      may("n_d", "1", "Dilatancy surface: M_d = M exp(n_d xi_R).", "0.1", coefficient),
      may("phi_cv_deg", "degrees", "Critical state friction angle.", "33", {.low = 1.0, .high = 60.0}),
      may("Q", "1", "Critical state line of Bolton.", "10", {.low = 5.0, .high = 20.0}),
      may("R", "1", "Critical state line of Bolton.", "1.5", {.low = 0.01, .high = 10.0}),
      may("m", "1", "Size of the yield surface.", "0.01", {.low = 1e-4, .high = 0.1}),
      may("h_o", "1", "Plastic modulus.", "max(0.3, (0.25 + D_R)/2)", {.low = 1e-3, .high = 100.0}),
      may("A_do", "1", "Dilatancy.", "from the initial stress", {.low = 0.0, .high = 100.0}),
      may("z_max", "1", "Largest fabric.", "from the initial stress", {.low = 1e-3, .high = 1e3}),
      may("c_z", "1", "Rate of fabric.", "250", {.low = 0.0, .high = 1e4}),
      may("c_eps", "1", "Strain accumulation.", "0.5 at D_R <= 0.55, falling to 0.2 at D_R >= 0.75",
          {.low = 0.0, .high = 100.0}),
      may("C_GD", "1", "Degradation of the elastic modulus with fabric.", "2", {.low = 1.0, .high = 100.0}),
      may("C_DR", "1", "Rotated dilatancy surface.", "5 + 25 (D_R - 0.35) in [1, 10]",
          {.low = 0.1, .high = 10.0}),
      may("C_kaf", "1", "Plastic modulus under static shear.", "5 + 220 (D_R - 0.26)^3 in [4, 35]",
          {.low = 4.0, .high = 35.0}),
      may("F_sed_min", "1", "Smallest reduction of stiffness in reconsolidation after shaking.",
          "min(0.03 exp(2.6 D_R), 0.99)", {.low = 1e-4, .high = 1.0}),
      may("p_sedo", "Pa", "Pressure scale of that reduction.", "`atmospheric_pressure`/5",
          {.low = 0.0, .high = 1e9}),
      {.name = "tolerance",
       .unit = "1",
       .meaning = "Relative error of a sub-step of the law's integration, in stress, back stress and fabric. "
                  "1e-3 saves a third of the law's time (docs/materials/pm4sand.md).",
       .fallback = "1e-4",
       .range = {.low = 1e-8, .high = 1e-2},
       .when = {"model", {scene::name(SoilModel::pm4sand)}}},
      {.name = "post_shake",
       .type = Type::boolean,
       .meaning = "The sand has been shaken and reconsolidates: elastic stiffness reduced by F_sed.",
       .fallback = "false",
       .when = {"model", {scene::name(SoilModel::pm4sand)}}},
  };
}

std::vector<Key> pdmy03_keys() {
  const auto may = [](std::string_view name, std::string_view unit, std::string_view meaning,
                      std::string_view otherwise, Range range = {}) {
    return optional({scene::name(SoilModel::pdmy03)}, name, unit, meaning, otherwise, range);
  };
  constexpr std::string_view set = "that of the recommended set of `relative_density`";
  return {
      may("shear_modulus", "Pa", "G_r at the reference pressure.", set, positive),
      may("bulk_modulus", "Pa", "B_r at the reference pressure.", set, positive),
      may("phase_transformation_deg", "degrees", "Angle of phase transformation, of the `cone`.", set,
          {.low = 1.0, .high = 65.0}),
      may("contraction_a", "1", "Contraction.", set, not_negative),
      may("contraction_b", "1", "Contraction: growth with the dilative strain of earlier cycles.", set,
          not_negative),
      may("contraction_c", "1", "Contraction: dependence on pressure.", set, coefficient),
      may("contraction_d", "1", "Contraction: dependence on the shear stress ratio.", set, not_negative),
      may("contraction_e", "1", "Contraction: dependence on static shear.", set,
          {.low = -100.0, .high = 100.0}),
      may("dilation_a", "1", "Dilation.", set, not_negative),
      may("dilation_b", "1", "Dilation: exponent of the strain of the present dilative phase.", set,
          {.low = 0.0, .high = 100.0}),
      may("dilation_c", "1", "Dilation: dependence on pressure.", set, {.low = -10.0, .high = 10.0}),
      may("peak_shear_strain", "1",
          "Octahedral shear strain at which the strength is reached, at the reference "
          "pressure.",
          "0.1", positive),
      may("reference_pressure", "Pa", "p_r, of the moduli.", "101e3", positive),
      may("pressure_exponent", "1", "d: moduli grow as pressure to this power.", "0.5",
          {.low = 0.0, .high = 1.0}),
      may("liquefaction_1", "1", "Share of dilative strain in the perfectly plastic zone.", "1",
          not_negative),
      may("liquefaction_2", "1", "Share of biased strain in the zone's translation.", "0", not_negative),
      may("zero_pressure_strength", "Pa", "Shear strength at zero pressure, S0.", "1.73e3", not_negative),
  };
}

} // namespace

std::vector<Key> sand_keys() {
  auto keys = common_keys();
  for (const auto& group : {pm4sand_keys(), pdmy03_keys()})
    keys.insert(keys.end(), group.begin(), group.end());
  return keys;
}

} // namespace tremolo::scene
