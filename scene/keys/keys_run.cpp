#include "scene/keys/keys_run.hpp"

#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"
#include "scene/keys/structure/keys_structure.hpp"

namespace tremolo::scene {

namespace {

Key deadline(std::string_view name, std::string_view meaning, std::string_view fallback) {
  return {.name = name,
          .unit = "s",
          .meaning = meaning,
          .fallback = fallback,
          .range = {.low = 0.0, .high = 86400.0, .low_open = true}};
}

Key interval(std::string_view name, std::string_view meaning, std::string_view fallback) {
  return {.name = name,
          .unit = "s",
          .meaning = meaning,
          .fallback = fallback,
          .range = {.low = 1e-4, .high = 1e4}};
}

Key line_end(std::string_view name, std::string_view meaning) {
  return {.name = name,
          .type = Type::numbers,
          .unit = "m",
          .meaning = meaning,
          .required = true,
          .count = 2,
          .form = "[x, y]"};
}

} // namespace

std::vector<Table> run_keys() {
  return {
      {.name = "coupling",
       .meaning = "The exchange between the processes.",
       .keys = {choice<ExchangeMode>(
                    "mode",
                    "`window`: a free field runs ahead and sends many steps in a frame; `lockstep`: one "
                    "exchange a "
                    "step. The results are the same bits.",
                    ExchangeMode::window),
                {.name = "window_steps",
                 .type = Type::integer,
                 .unit = "1",
                 .meaning = "Steps in a frame in mode `window`.",
                 .fallback = "64",
                 .range = {.low = 1.0, .high = 65536.0}},
                deadline("connect_deadline_s", "Time within which every process must have connected.", "30"),
                deadline("step_deadline_s",
                         "Longest wait for a step of another process; 20 times the median of what its last "
                         "ones took, if that is more.",
                         "60"),
                deadline("shutdown_deadline_s", "Time that processes have to end.", "2")}},
      {.name = "record",
       .meaning = "Recording of the exchange, see docs/recordings.md.",
       .keys = {{.name = "exchange",
                 .type = Type::boolean,
                 .meaning =
                     "Whether everything that the processes exchange is written to `exchange.h5`, from which "
                     "a free field can be served again.",
                 .fallback = "false"},
                choice<OnFullDisk>(
                    "on_full_disk",
                    "What the run does when the recording can no longer be written: `stop` ends it; `go_on` "
                    "ends the recording, which is then marked as incomplete.",
                    OnFullDisk::stop)}},
      {.name = "checkpoint",
       .meaning = "Sets of files from which `tremolo resume` goes on, see docs/checkpoints.md.",
       .keys = {{.name = "every_steps",
                 .type = Type::integer,
                 .unit = "1",
                 .meaning = "Steps of the domain from one to the next, instead of wall time.",
                 .otherwise = "by `every_wall_s`",
                 .range = {.low = 1.0, .high = 1e9}},
                {.name = "every_wall_s",
                 .unit = "s",
                 .meaning = "Wall time from one to the next.",
                 .fallback = "60",
                 .range = {.low = 0.0, .high = 1e7, .low_open = true}},
                {.name = "keep",
                 .type = Type::integer,
                 .unit = "1",
                 .meaning = "The newest sets that are kept; 0: none are made.",
                 .fallback = "2",
                 .range = {.low = 0.0, .high = 1e6}}}},
      {.name = "monitor",
       .kind = Kind::array,
       .meaning = "A material point of soil or of a structure whose history is recorded.",
       .keys = {{.name = "name", .type = Type::text, .meaning = "Its name in results.", .required = true},
                {.name = "point",
                 .type = Type::numbers,
                 .unit = "m",
                 .meaning = "Where it lies at the start, in or on the edge of a region, or of its structure.",
                 .required = true,
                 .count = 2,
                 .form = "[x, y]"},
                {.name = "structure",
                 .type = Type::text,
                 .meaning = "Name of the `[[structure]]` that it moves with; it may lie in a hole.",
                 .otherwise = "it follows the soil"}}},
      {.name = "line",
       .kind = Kind::array,
       .meaning =
           "Points of soil along a straight line, whose histories are recorded as those of monitors, for "
           "profiles; see docs/profiles.md.",
       .keys = {{.name = "name", .type = Type::text, .meaning = "Its name in results.", .required = true},
                line_end("from", "One end, in soil at the start."),
                line_end("to", "The other end; all points between lie in soil, too."),
                {.name = "spacing",
                 .unit = "m",
                 .meaning = "Largest distance from point to point. A line has at most 100 points.",
                 .otherwise = "`size` of [mesh]",
                 .range = above_zero}}},
      {.name = "sliding_mass",
       .kind = Kind::array,
       .meaning =
           "Soil that may slide, of which the mean acceleration, velocity and displacement are recorded, "
           "for Newmark's displacement; see docs/profiles.md.",
       .keys = {{.name = "name", .type = Type::text, .meaning = "Its name in results.", .required = true},
                {.name = "polygon",
                 .type = Type::polygon,
                 .unit = "m",
                 .meaning =
                     "Corners around it in either sense of rotation, along the slip surface and anyhow "
                     "above the ground: what counts is the soil within at the start.",
                 .otherwise = "`circle`"}}},
      circle_table(
          "sliding_mass.circle",
          "A circle as slip surface, `circle = { centre = [x, y], radius = r }` instead of `polygon`."),
      {.name = "output",
       .meaning = "What is written to the run file.",
       .keys =
           {interval("every_s", "Interval of particle frames.", "0.1"),
            interval(
                "history_every_s",
                "Interval of histories (monitors, lines, sliding masses, structures), energy balance and "
                "boundary exchange.",
                "0.01"),
            {.name = "fields",
             .type = Type::choices,
             .meaning =
                 "Particle fields of a frame. `state`: the state variables of the soil's law, such as the "
                 "equivalent plastic strain. In a case with [water], `stress` is effective below the table, "
                 "and "
                 "there are four fields more, zero in dry soil: `pore_pressure`; "
                 "`excess_pore_pressure`, beyond the hydrostatic one of the present place; "
                 "`pore_pressure_ratio`, that over the vertical effective stress before the shaking; "
                 "`darcy_velocity`, the flux of water through the grains.",
             .fallback = "displacement, velocity, acceleration, stress, state, pore_pressure, "
                         "excess_pore_pressure, pore_pressure_ratio, darcy_velocity",
             .choices = all_words<OutputField>()}}},
      {.name = "verify",
       .meaning = "Acceptance of `tremolo verify`.",
       .keys = {{.name = "tolerance",
                 .unit = "1",
                 .meaning = "Largest relative L2 error of particle velocity against the exact field.",
                 .fallback = "0.05",
                 .range = {.low = 0.0, .high = 1.0, .low_open = true}}}},
  };
}

} // namespace tremolo::scene
