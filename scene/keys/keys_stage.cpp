#include "scene/keys/keys_stage.hpp"

namespace tremolo::scene {

Table stage_table() {
  return {
      .name = "stage",
      .kind = Kind::array,
      .required = true,
      .meaning =
          "The stages in their order: at most one of gravity, then one of shaking, then at most one of "
          "rest. Without a gravity stage the model is weightless. See docs/stages.md.",
      .keys = {
          choice(
              "kind", {"gravity", "shaking", "rest"},
              "`gravity`: base fixed, sides on rollers, brought to rest by damped relaxation; what held the "
              "model then acts as static traction. `shaking`: the motion enters, t = 0 at its start. `rest`: "
              "strong motion is over and sand reconsolidates, with the stiffness that `pm4sand` has after "
              "shaking; what is left of the motion goes on."),
          {.name = "name",
           .type = Type::text,
           .meaning =
               "What log, reports and `tremolo run --until` call the stage. No two have the same name.",
           .otherwise = "its kind"},
          {.name = "acceleration",
           .unit = "m/s2",
           .meaning = "Gravity, downwards.",
           .fallback = "9.81",
           .range = positive,
           .when = {"kind", {"gravity"}}},
          {.name = "residual",
           .unit = "1",
           .meaning = "Unbalanced nodal forces at rest, relative to the nodal weights (2-norms).",
           .fallback = "1e-9",
           .range = {.low = 1e-12, .high = 0.1},
           .when = {"kind", {"gravity"}}},
          {.name = "max_time_s",
           .unit = "s",
           .meaning = "Simulated time within which rest must be reached.",
           .fallback = "60",
           .range = {.low = 0.0, .high = 1e4, .low_open = true},
           .when = {"kind", {"gravity"}}},
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
               "in magnitude.",
           .otherwise = "it lasts that long",
           .range = {.low = 0.0, .high = 1.0, .low_open = true},
           .when = {"kind", {"rest"}}},
          {.name = "every_s",
           .unit = "s",
           .meaning = "Interval of particle frames in the rest.",
           .otherwise = "that of [output]",
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
          {.name = "history_every_s",
           .unit = "s",
           .meaning = "Interval of histories in the rest.",
           .otherwise = "that of [output]",
           .range = {.low = 0.0, .high = 1e4, .low_open = true},
           .when = {"kind", {"rest"}}}}};
}

} // namespace tremolo::scene
