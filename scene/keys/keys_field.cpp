#include "scene/keys/keys_field.hpp"

#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"
#include "scene/keys/soil/keys_random.hpp"
#include "scene/keys/stages/keys_motion.hpp"

namespace tremolo::scene {

namespace {

Key damping_ratio() {
  return {.name = "damping",
          .unit = "1",
          .meaning =
              "Fraction of critical damping of a layer without `soil`; [damping] says what it is at which "
              "frequency.",
          .otherwise = "that of the `soil`, or `[damping] ratio`",
          .range = {.low = 0.0, .high = 1.0, .high_open = true}};
}

Key half_space_damping() {
  auto key = damping_ratio();
  key.otherwise = {};
  key.fallback = "0";
  key.meaning =
      "Fraction of critical damping, for `wave` and `eql`; columns stand on an undamped half-space.";
  return key;
}

Table damping() {
  return {
      .name = "damping",
      .meaning =
          "Material damping at small strain, of the free field and of the domain. In time, where domain and "
          "columns march, it is that of relaxation mechanisms (`constant`), which shorten an explicit step "
          "by a few per cent, or proportional to stiffness, sigma = D_e (eps + beta d eps/dt), which "
          "shortens "
          "it from t to sqrt(t^2 + beta^2) - beta.",
      .keys = {
          choice<DampingModel>(
              "model",
              "How damping depends on frequency. `constant`: the same ratio over a `band` of frequencies, in "
              "domain and all models. `kelvin_voigt`: proportional to it, domain and all models. `rayleigh`: "
              "the ratio at two frequencies, its part proportional to mass relative to the rock's motion "
              "without soil; domain, columns and, at vertical incidence, `wave`. `hysteretic` G (1 + 2 i "
              "xi), "
              "`shake` G (1 - 2 xi^2 + 2 i xi sqrt(1 - xi^2)) and `kjartansson`: the same or nearly so at "
              "all "
              "frequencies, `wave` and `eql`; domain and columns then take Kelvin-Voigt damping with the "
              "ratio at `reference_hz`. Under `none` the curves of `eql` damp as `hysteretic`.",
              DampingModel::none),
          {.name = "ratio",
           .unit = "1",
           .meaning = "Fraction of critical damping of soils and layers that have none of their own.",
           .fallback = "0",
           .range = {.low = 0.0, .high = 1.0, .high_open = true},
           .when = {"model", {"rayleigh", "kelvin_voigt", "hysteretic", "shake", "kjartansson", "constant"}}},
          {.name = "frequencies",
           .type = Type::numbers,
           .unit = "Hz",
           .meaning = "The two frequencies at which Rayleigh damping has the ratio.",
           .required = true,
           .range = above_zero,
           .count = 2,
           .form = "[f1, f2]",
           .when = {"model", {"rayleigh"}}},
          {.name = "reference_hz",
           .unit = "Hz",
           .meaning =
               "The frequency at which the damping of `kelvin_voigt`, of domain and columns has the "
               "ratio, and at which the stiffness of `kjartansson` and `constant` is that of the soil.",
           .otherwise =
               "none; needed by `kelvin_voigt`, `kjartansson`, `constant`, a damped domain and damped "
               "columns",
           .range = above_zero,
           .when = {"model", {"kelvin_voigt", "hysteretic", "shake", "kjartansson", "constant"}}},
          {.name = "band",
           .type = Type::numbers,
           .unit = "Hz",
           .meaning = "Between which frequencies the ratio is constant.",
           .otherwise = "[0.1, 25]",
           .range = above_zero,
           .count = 2,
           .form = "[f1, f2]",
           .when = {"model", {"constant"}}},
          {.name = "mechanisms",
           .type = Type::integer,
           .unit = "1",
           .meaning =
               "How many relaxation mechanisms `constant` damping has: 4 keep the ratio within 1.4 % over "
               "0.1 to 25 Hz, 3 within 5.5 %, 6 within 0.1 %. Each costs 24 bytes a particle.",
           .otherwise = "4",
           .range = {.low = 1.0, .high = 12.0},
           .when = {"model", {"constant"}}}}};
}

} // namespace

std::vector<Key> layer_keys() {
  auto keys = elastic_keys();
  for (Key& key : keys)
    if (key.name == "density") {
      key.required = false;
      key.otherwise = "that of the `soil`";
    }
  keys.insert(keys.begin(), {.name = "thickness",
                             .unit = "m",
                             .meaning = "Thickness of the layer.",
                             .required = true,
                             .range = above_zero});
  keys.push_back(
      {.name = "soil",
       .type = Type::text,
       .meaning = "Name of a `[soil]`: the layer has its elastic constants and, in columns, its law.",
       .otherwise = "linear elastic, with constants of its own"});
  keys.push_back(damping_ratio());
  return keys;
}

std::vector<Table> field_keys() {
  std::vector<Table> tables = motion_tables();
  for (
      const Table& table : std::vector<Table>{
          {.name = "surface",
  .meaning = "The free surface of the free field. Required unless the base is a shaking table.",
  .keys = {{.name = "level", .unit = "m", .meaning = "y of the free surface.", .required = true}}},
          {.name = "halfspace",
          .meaning =
               "The homogeneous half-space below the profile, up to the surface where there is no "
               "`[[profile]]`. "
               "Either `young` and `poisson`, or `vs` and `vp`. Required unless the base is a shaking table.",
          .keys = with_elastic_keys({half_space_damping()})},
          {.name = "profile",
          .kind = Kind::array,
          .meaning =
               "Layers of the free field from the surface down; the half-space continues below the last one.",
          .keys = layer_keys()},
          random_profile_keys(),
          damping(),
      })
    tables.push_back(table);
  return tables;
}

} // namespace tremolo::scene
