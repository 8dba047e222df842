#include "scene/keys/soil/keys_water.hpp"

#include "materials/water/pore_water.hpp"
#include "scene/keys/soil/keys_elastic.hpp"

namespace tremolo::scene {

std::vector<Key> level_keys() {
  return {
      {.name = "level",
       .unit = "m",
       .meaning = "y of a level water table, an elevation as all y are, not a depth. Above the ground it is "
                  "the level of free water, whose pressure the ground carries.",
       .otherwise = "`line`, or `seepage = true` with `left` and `right`"},
      {.name = "line",
       .type = Type::line,
       .unit = "m",
       .meaning =
           "Corners of a phreatic line from left to right, over the whole width of the model, in place "
           "of `level`. Water rests below it: its pressure is that of the line straight above. That "
           "is not flow; where the line slopes, `seepage = true` is better.",
       .otherwise = "`level`"},
      {.name = "seepage",
       .type = Type::boolean,
       .meaning = "Water flows steadily through the ground, between the levels `left` and `right`. The flow "
                  "is found before the gravity stage, with its phreatic surface and where it leaves the "
                  "ground; every soil of the domain needs a permeability.",
       .fallback = "false"},
      {.name = "left",
       .unit = "m",
       .meaning = "y of the water at the left side: of the table in the ground there, or of free water, "
                  "which reaches to where the ground rises above it.",
       .required = true,
       .when = {"seepage", {"true"}}},
      {.name = "right",
       .unit = "m",
       .meaning = "y of the water at the right side, likewise.",
       .required = true,
       .when = {"seepage", {"true"}}}};
}

Table water_table() {
  Table table{
      .name = "water",
      .meaning =
          "Water in the pores of the ground below a level table, or a phreatic line, or in steady flow. "
          "Soil above it is dry, and free water stands over ground that lies below it.",
      .keys = {
          {.name = "density",
           .unit = "kg/m3",
           .meaning = "Density of water.",
           .fallback = "1000",
           .range = {.low = 500.0, .high = 2000.0}},
          {.name = "bulk_modulus",
           .unit = "Pa",
           .meaning = "Bulk modulus of water; less with entrapped air.",
           .fallback = "2.2e9",
           .range = {.low = 1e5, .high = 1e11}},
          {.name = "cavitation_pressure",
           .unit = "Pa",
           .meaning = "The lowest pore pressure there can be, relative to the atmosphere.",
           .fallback = "-90e3",
           .range = {.low = -1e9, .high = 0.0}},
      }};
  const std::vector<Key> levels = level_keys();
  table.keys.insert(table.keys.begin(), levels.begin(), levels.end());
  return table;
}

std::vector<Key> pore_keys() {
  return {
      {.name = "porosity",
       .unit = "1",
       .meaning = "Volume of pores by that of the soil; or `void_ratio`. Only with `[water]`, as the other "
                  "keys of pores. The density below the table follows from it, `grain_density` and that of "
                  "water; above the table the soil has that of its grains alone.",
       .otherwise = "`void_ratio`; of `pm4sand` from its relative density, e_max and e_min; of `pdmy03` "
                    "from its saturated density",
       .range = {.low = 0.01, .high = 0.95}},
      {.name = "void_ratio",
       .unit = "1",
       .meaning = "Volume of pores by that of the grains, porosity/(1 - porosity).",
       .otherwise = "`porosity`",
       .range = {.low = 0.0102, .high = 19.0}},
      {.name = "grain_density",
       .unit = "kg/m3",
       .meaning = "Density of the grains.",
       .otherwise = "2650, quartz",
       .range = {.low = 1000.0, .high = 10000.0}},
      {.name = "permeability",
       .unit = "m/s",
       .meaning = "Hydraulic conductivity k of Darcy's law, n w = k i. Soil below the water table with "
                  "`drainage = \"coupled\"` needs it.",
       .otherwise = "none",
       .range = above_zero},
      {.name = "drainage",
       .type = Type::choice,
       .meaning = "What water does below the table. `coupled`: it flows by Darcy's law. `undrained`: it "
                  "moves with the grains, and pore pressure stays where it rises. `drained`: its pressure "
                  "stays that of the undisturbed water, as in gravel.",
       .otherwise = "`coupled`",
       .choices = all_words<materials::Drainage>()},
  };
}

} // namespace tremolo::scene
