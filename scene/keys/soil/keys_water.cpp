#include "scene/keys/soil/keys_water.hpp"

#include "materials/water/pore_water.hpp"
#include "scene/keys/soil/keys_elastic.hpp"

namespace tremolo::scene {

Table water_table() {
  return {
      .name = "water",
      .meaning = "Water in the pores of the ground below a level table. Soil above it is dry.",
      .keys = {
          {.name = "level",
           .unit = "m",
           .meaning = "y of the water table, an elevation as all y are, not a depth. Above the ground it is "
                      "the level of free water, whose pressure the ground carries.",
           .required = true},
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
       .range = positive},
      {.name = "drainage",
       .type = Type::choice,
       .meaning = "What water does below the table. `coupled`: it flows by Darcy's law. `undrained`: it "
                  "moves with the grains, and pore pressure stays where it rises. `drained`: its pressure "
                  "stays hydrostatic, as in gravel.",
       .otherwise = "`coupled`",
       .choices = all_words<materials::Drainage>()},
  };
}

} // namespace tremolo::scene
