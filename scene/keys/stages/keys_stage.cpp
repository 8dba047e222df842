#include "scene/keys/stages/keys_stage.hpp"

#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"
#include "scene/keys/soil/keys_water.hpp"

namespace tremolo::scene {

Table stage_table() {
  Table table{
      .name = "stage",
      .kind = Kind::array,
      .required = true,
      .meaning =
          "The stages in their order: at most one of gravity, then any number of loads, "
          "constructions and changes of the water, then one of shaking, then any number of rests, loads, "
          "constructions and further shakings. Without a gravity stage the "
          "model is weightless. See docs/stages.md.",
      .keys = {
          choice(
              "kind", {"gravity", "load", "construction", "water", "shaking", "rest"},
              "`gravity`: base fixed, sides on rollers, brought to rest by damped relaxation; what held the "
              "model then acts as static traction. `load`: a load comes onto the surface, or onto a "
              "structure, and stays, and the ground comes to rest under it in the same way. `construction`: "
              "soil and structures are placed "
              "and removed, likewise. After a shaking both happen while the ground goes on in its own time. "
              "`water`: it has other levels, likewise. `shaking`: the motion enters, "
              "t = 0 at its "
              "start. `rest`: "
              "strong motion is over and sand reconsolidates, with the stiffness that `pm4sand` has after "
              "shaking; what is left of the motion goes on."),
          {.name = "name",
           .type = Type::text,
           .meaning = "What log, reports and `--until` call the stage. No two have the same name.",
           .otherwise = "its kind"},
          {.name = "acceleration",
           .unit = "m/s2",
           .meaning = "Gravity, downwards.",
           .fallback = "9.81",
           .range = above_zero,
           .when = {"kind", {"gravity"}}},
          {.name = "residual",
           .unit = "1",
           .meaning = "Unbalanced nodal forces at rest, relative to the nodal weights (2-norms).",
           .fallback = "1e-9",
           .range = {.low = 1e-12, .high = 0.1},
           .when = {"kind", {"gravity", "load", "construction", "water"}}},
          {.name = "max_time_s",
           .unit = "s",
           .meaning = "Simulated time within which rest must be reached, after the ramp.",
           .fallback = "60",
           .range = {.low = 0.0, .high = 1e4, .low_open = true},
           .when = {"kind", {"gravity", "load", "construction", "water"}}},
          {.name = "place",
           .type = Type::texts,
           .meaning = "Names of regions, structures and props that come to stand. What is placed before it "
                      "is removed "
                      "is not there at the start. Soil begins with the stress of its own weight.",
           .otherwise = "nothing",
           .when = {"kind", {"construction"}}},
          {.name = "remove",
           .type = Type::texts,
           .meaning = "Names of regions, structures and props that go.",
           .otherwise = "nothing",
           .when = {"kind", {"construction"}}},
          {.name = "drainage",
           .type = Type::choice_by_name,
           .meaning =
               "What pore water does in the stage. `drained`: it has time to flow, and the grains take all "
               "of the change. `undrained`: it moves with the grains of soils that are not `drained` "
               "themselves; the excess pressure lasts until a drained stage, or flows off while the "
               "ground is shaken and rests. In a `load` or a `construction` it can be said soil by soil, "
               "`{ clay = \"undrained\" }`; soils that are not named are drained.",
           .fallback = scene::name(StageDrainage::drained),
           .choices = all_words<StageDrainage>(),
           .when = {"kind", {"load", "construction", "water"}}},
          {.name = "x_m",
           .type = Type::numbers,
           .unit = "m",
           .meaning = "Where the load begins and ends: it lies on the uppermost soil between.",
           .otherwise = "required, but with `structure`",
           .count = 2,
           .form = "[x_min, x_max]",
           .when = {"kind", {"load"}}},
          {.name = "pressure_pa",
           .unit = "Pa",
           .meaning = "Onto the surface, along its present normal and per present length.",
           .fallback = "0",
           .range = {.low = 0.0, .high = 1e8},
           .when = {"kind", {"load"}}},
          {.name = "shear_pa",
           .unit = "Pa",
           .meaning = "Along the surface, towards +x.",
           .fallback = "0",
           .range = {.low = -1e8, .high = 1e8},
           .when = {"kind", {"load"}}},
          {.name = "structure",
           .type = Type::text,
           .meaning = "Name of the structure that carries the load.",
           .otherwise = "it lies on the surface",
           .when = {"kind", {"load"}}},
          {.name = "force_n_per_m",
           .type = Type::numbers,
           .unit = "N/m",
           .meaning = "Force at the centroid of the structure, per metre out of plane; an elastic structure "
                      "takes it spread as its mass is.",
           .otherwise = "required with `structure`",
           .range = {.low = -1e10, .high = 1e10},
           .count = 2,
           .form = "[fx, fy]",
           .when = {"kind", {"load"}}},
          {.name = "ramp_s",
           .unit = "s",
           .meaning = "Time in which the change grows, along half of a cosine. After a shaking it is the "
                      "soil's own, "
                      "and the stage lasts as long.",
           .otherwise =
               "five periods 4 H/c_s of the ground, with the depth H of the mesh and its slowest soil; "
               "required after a shaking",
           .range = {.low = 0.0, .high = 1e4, .low_open = true},
           .when = {"kind", {"load", "construction", "water"}}},
          {.name = "duration_s",
           .unit = "s",
           .meaning = "Length of the stage.",
           .required = true,
           .range = {.low = 0.0, .high = 1e4, .low_open = true},
           .when = {"kind", {"shaking", "rest"}}},
          {.name = "time_factor",
           .unit = "1",
           .meaning =
               "Water flows so many times as easily, and time passes so many times as fast. The `time` of "
               "results is the soil's. `check` says how large an error the factor brings.",
           .fallback = "1",
           .range = {.low = 1.0, .high = 1e4},
           .when = {"kind", {"rest"}}},
          {.name = "until_ratio",
           .unit = "1",
           .meaning =
               "Ends the run early, as soon as no particle has an excess pore pressure ratio that is larger "
               "in magnitude; only in the last stage.",
           .otherwise = "it lasts that long",
           .range = {.low = 0.0, .high = 1.0, .low_open = true},
           .when = {"kind", {"rest"}}},
          {.name = "every_s",
           .unit = "s",
           .meaning = "Interval of particle frames in the rest.",
           .otherwise = "`time_factor` times that of [output]",
           .range = {.low = 0.0, .high = 1e4, .low_open = true},
           .when = {"kind", {"rest"}}},
          {.name = "growth",
           .unit = "1",
           .meaning =
               "Each interval of particle frames is so many times as long as the one before: with more "
               "than 1 the frames stand at equal distances on a logarithmic axis.",
           .fallback = "1",
           .range = {.low = 1.0, .high = 10.0},
           .when = {"kind", {"rest"}}},
          {.name = "times_s",
           .type = Type::series,
           .unit = "s",
           .meaning = "Times after the start of the rest at which particle frames are written, rising.",
           .otherwise = "at the intervals of `every_s`",
           .range = {.low = 0.0, .high = 1e7, .low_open = true},
           .when = {"kind", {"rest"}}},
          {.name = "history_every_s",
           .unit = "s",
           .meaning = "Interval of histories in the rest.",
           .otherwise = "`time_factor` times that of [output]",
           .range = {.low = 0.0, .high = 1e4, .low_open = true},
           .when = {"kind", {"rest"}}}}};
  for (Key key : level_keys()) {
    if (key.when.key.empty())
      key.when = {"kind", {"water"}};
    table.keys.push_back(key);
  }
  return table;
}

} // namespace tremolo::scene
