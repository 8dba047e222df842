// Keys of soil tests and calibrations, and of the soils in the library.

#include "materials/soiltest/cyclic/cyclic_strength.hpp"
#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"
#include "scene/keys/soil/keys_soil.hpp"

namespace tremolo::scene {

namespace {

Key line(std::string_view name, std::string_view meaning) {
  return {.name = name, .type = Type::text, .meaning = meaning, .required = true};
}

Table top(std::vector<Key> keys) {
  return {
      .name = "", .meaning = "Keys at the top of the file, before the first table.", .keys = std::move(keys)};
}

Table soil() {
  return {.name = "soil", .required = true, .meaning = soil_meaning, .keys = soil_keys()};
}

Table test() {
  return {
      .name = "test",
      .required = true,
      .meaning = "The apparatus and the state from which loading starts; strains are counted from there. y "
                 "is vertical. "
                 "Simple shear and oedometer have eps_xx = 0, triaxial tests sigma_zz = sigma_xx, all others "
                 "eps_zz = 0.",
      .keys = {
          choice<soiltest::Kind>(
              "kind",
              "Which test. Triaxial: of laws in three dimensions. `path`: strains or stresses prescribed "
              "by the "
              "`file` of the loading."),
          choice<soiltest::Drainage>(
              "drainage",
              "`drained`: the stress that the apparatus holds (vertical in simple shear, lateral in "
              "compression) is "
              "effective. `undrained`: it is total, the pores hold water. `constant_volume`: no "
              "volumetric strain, "
              "as simple shear is done in the laboratory."),
          {.name = "pore_stiffness",
           .unit = "Pa",
           .meaning = "K_w/n, bulk modulus of water over porosity.",
           .fallback = "5e9",
           .range = above_zero,
           .when = {"drainage", {"undrained"}}},
          {.name = "vertical_stress",
           .unit = "Pa",
           .meaning = "Effective vertical stress, positive in compression.",
           .required = true,
           .range = above_zero},
          {.name = "k0",
           .unit = "1",
           .meaning = "Horizontal over vertical effective stress.",
           .otherwise = "0.5 in simple shear and oedometer, 1 in the others",
           .range = {.low = 0.0, .high = 10.0, .low_open = true}},
          {.name = "shear_bias",
           .unit = "1",
           .meaning = "Static shear stress over vertical stress, alpha.",
           .fallback = "0",
           .range = {.low = -1.0, .high = 1.0},
           .when = {"kind", {"direct_simple_shear", "path"}}},
          choice("bias_applied", {"by_drained_shear", "in_initial_stress"},
                 "How the static shear came about: by drained simple shear before the test, or it is part of "
                 "the stress "
                 "from which the law begins.",
                 "by_drained_shear"),
          {.name = "strain_increment",
           .unit = "1",
           .meaning = "Size of the steps of the strain that drives the test.",
           .fallback = "1e-5",
           .range = {.low = 1e-8, .high = 1e-2}},
          {.name = "every",
           .type = Type::integer,
           .unit = "1",
           .meaning =
               "Increments from one row of the history to the next; reversals and the end are always kept.",
           .fallback = "10",
           .range = {.low = 1.0, .high = 1e6}},
      }};
}

Table loading() {
  const Condition cycles = {"kind", {name(LoadingKind::cyclic_stress)}};
  return {
      .name = "loading",
      .meaning = "What is done to the soil. Strain is gamma_xy in simple shear, otherwise the axial strain. "
                 "Required by "
                 "`tremolo soiltest`.",
      .keys = {
          choice<LoadingKind>(
              "kind",
              "`monotonic`: to a strain. `cyclic_stress`: between tau_0 +- stress_ratio times the "
              "vertical stress. "
              "`cyclic_strain`: between +- amplitude, one amplitude after the other. `modulus_curve`: the "
              "same, each "
              "amplitude on a fresh specimen; G/Gmax and damping of its last cycle. `path`: as a table "
              "says."),
          {.name = "strain",
           .unit = "1",
           .meaning = "Where monotonic loading ends.",
           .fallback = "0.1",
           .range = {.low = 0.0, .high = 1.0, .low_open = true},
           .when = {"kind", {name(LoadingKind::monotonic)}}},
          {.name = "stress_ratio",
           .type = Type::series,
           .unit = "1",
           .meaning =
               "Cyclic stress ratio CSR = tau_cyc/vertical_stress; several make a cyclic strength curve.",
           .required = true,
           .range = {.low = 0.0, .high = 3.0, .low_open = true},
           .when = cycles},
          {.name = "largest_strain",
           .unit = "1",
           .meaning = "Strain that ends the test.",
           .fallback = "0.06",
           .range = {.low = 0.0, .high = 1.0, .low_open = true},
           .when = cycles},
          {.name = "most_cycles",
           .unit = "1",
           .meaning = "Cycles that end the test.",
           .fallback = "100",
           .range = {.low = 0.0, .high = 1e5, .low_open = true},
           .when = cycles},
          {.name = "largest_pore_pressure_ratio",
           .unit = "1",
           .meaning = "Excess pore pressure ratio r_u that ends the test.",
           .otherwise = "none does",
           .range = {.low = 0.0, .high = 1.0, .low_open = true},
           .when = cycles},
          {.name = "strain_amplitude",
           .type = Type::series,
           .unit = "1",
           .meaning = "Amplitudes of strain.",
           .required = true,
           .range = {.low = 0.0, .high = 0.2, .low_open = true},
           .when = {"kind", {name(LoadingKind::cyclic_strain), name(LoadingKind::modulus_curve)}}},
          {.name = "cycles",
           .type = Type::integer,
           .unit = "1",
           .meaning = "Cycles of each amplitude.",
           .fallback = "3",
           .range = {.low = 1.0, .high = 1000.0},
           .when = {"kind", {name(LoadingKind::cyclic_strain), name(LoadingKind::modulus_curve)}}},
          {.name = "file",
           .type = Type::text,
           .meaning =
               "Table of the path, relative to the test file: columns `step,eps_xx,eps_yy,gamma_xy`, of what "
               "is prescribed by stress `sig_xx`, `sig_yy`, `sig_xy`. A written history can be replayed.",
           .required = true,
           .when = {"kind", {name(LoadingKind::path)}}},
          {.name = "by_stress",
           .type = Type::choices,
           .meaning = "Components that are prescribed by stress instead of strain.",
           .otherwise = "none",
           .choices = {"sig_xx", "sig_yy", "sig_xy", "sig_zz"},
           .when = {"kind", {name(LoadingKind::path)}}},
          {.name = "stress_unit",
           .type = Type::choice,
           .meaning = "Unit of the stresses in the `file`, positive in tension.",
           .fallback = "Pa",
           .choices = {"Pa", "kPa"},
           .when = {"kind", {name(LoadingKind::path)}}},
      }};
}

Table target() {
  return {
      .name = "target",
      .meaning =
          "The cyclic strength that `tremolo calibrate` fits the soil to; required by it. Either `curve` or "
          "`stress_ratio`.",
      .keys = {
          {.name = "curve",
           .type = Type::choice,
           .meaning =
               "`idriss_boulanger`: the strength of clean sand by Idriss & Boulanger (2008) at the soil's "
               "relative density, (N1)60 = 46 D_R^2, times K_sigma of the vertical stress. Without "
               "`shear_bias`.",
           .otherwise = "`stress_ratio`",
           .choices = {"idriss_boulanger"}},
          {.name = "stress_ratio",
           .unit = "1",
           .meaning = "Cyclic stress ratio that is to reach the criterion in the wanted number of cycles.",
           .otherwise = "`curve`",
           .range = {.low = soiltest::least_stress_ratio, .high = soiltest::largest_stress_ratio}},
          {.name = "cycles",
           .unit = "1",
           .meaning = "Wanted number of cycles.",
           .fallback = "15",
           .range = {.low = 0.5, .high = 1000.0}},
          choice<soiltest::Criterion>(
              "criterion",
              "What counts as failure: 1, 3 or 5 % strain, 5 % from the smallest to the largest, or r_u = "
              "0.98.",
              soiltest::Criterion::strain_3pc),
          choice("parameter", {"contraction_rate"},
                 "The parameter that is fitted: `contraction_rate` of `pm4sand`; its value in [soil] is the "
                 "first guess.",
                 "contraction_rate"),
          {.name = "least",
           .unit = "1",
           .meaning = "Smallest value of the parameter.",
           .fallback = "0.01",
           .range = {.low = 1e-6, .high = 1e6}},
          {.name = "most",
           .unit = "1",
           .meaning = "Largest value of the parameter.",
           .fallback = "10",
           .range = {.low = 1e-6, .high = 1e6}},
      }};
}

} // namespace

KeyTable soil_test_keys() {
  static const std::vector<Table> tables = {top({line("title", "One line that names the test.")}), soil(),
                                            test(), loading(), target()};
  return tables;
}

KeyTable library_keys() {
  static const std::vector<Table> tables = {
      top({line("title", "One line that names the soil."), line("source", "Where the values are from."),
           line("basis", "What of them is measured, and what is derived or assumed.")}),
      soil()};
  return tables;
}

} // namespace tremolo::scene
