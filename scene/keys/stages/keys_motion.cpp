#include "scene/keys/stages/keys_motion.hpp"

#include "motion/record.hpp"
#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"

namespace tremolo::scene {

namespace {

/// The keys that describe a record.
std::vector<Key> record_keys() {
  return {
      {.name = "file",
       .type = Type::text,
       .meaning =
           "Record, relative to the case file: PEER format (AT2, VT2, DT2), the text of a network "
           "(K-NET, SMC, "
           "COSMOS, CSMIP, GeoNet, ESM, ...), a table of time and values, or HDF5. "
           "The motion is the band-limited function through the samples: its spectrum is the record's up "
           "to its Nyquist frequency. Velocities rise with a half cosine over the first 0.1 s; after the "
           "last sample a half cosine takes the velocity to zero within 1 s.",
       .otherwise = "`pulse`"},
      {.name = "quantity",
       .type = Type::choice,
       .meaning = "What the file holds; only with `file`.",
       .otherwise = "as the file says",
       .choices = all_words<motion::Quantity>()},
      {.name = "unit",
       .type = Type::choice,
       .meaning = "Unit of the file's samples; only with `file`.",
       .otherwise = "as the file says",
       .choices = all_words<motion::Unit>()},
      {.name = "component",
       .type = Type::text,
       .meaning = "Which component of a file that holds several: its number from 1, its name or a part "
                  "of it; only with `file`.",
       .otherwise = "the only one"},
      {.name = "column",
       .type = Type::text,
       .meaning = "Which column of a table holds the motion: its number from 1, its name or a part of "
                  "it; only with `file`.",
       .otherwise = "the second of two"},
      {.name = "scale", .unit = "1", .meaning = "Factor on the record; only with `file`.", .fallback = "1"}};
}

/// Keys for the direction of incidence of a plane wave, and the point at which its motion is given.
std::vector<Key> way_keys() {
  return {{.name = "angle_deg",
           .unit = "degrees",
           .meaning = "Angle of incidence from the vertical, travelling to +x, +y.",
           .otherwise = "required, but of a shaking table",
           .range = {.low = 0.0, .high = 90.0, .high_open = true}},
          {.name = "reference",
           .type = Type::numbers,
           .unit = "m",
           .meaning =
               "Where the incident wave has exactly this motion: of its polarisation SV (cos, -sin), P (sin, "
               "cos) of the angle for `incident`; `outcrop` and `within` at the top of the half-space.",
           .otherwise = "required, but of a shaking table",
           .count = 2,
           .form = "[x, y]"}};
}

/// The keys of a plane wave but for its direction: whose motion it has, and its type.
std::vector<Key> wave_keys() {
  return {{.name = "kind",
           .type = Type::choice,
           .meaning =
               "Whose motion it is; a `file` needs it. `incident`: of the upgoing wave alone, along its "
               "polarisation. `outcrop`: of the surface of the bare half-space, horizontal for SV and "
               "vertical for P; vertically twice the incident wave. `within`: of the top of the half-space "
               "under the `[[profile]]`, as a downhole sensor records it, or of a shaking table.",
           .otherwise = "`incident` of a `pulse`",
           .choices = all_words<motion::MotionKind>()},
          choice<Wave>("wave", "Type of the incident wave.")};
}

void append(std::vector<Key>& keys, std::vector<Key> more) {
  keys.insert(keys.end(), more.begin(), more.end());
}

Table pulse_table(std::string_view name) {
  return {.name = name,
          .meaning = "Ricker velocity pulse V (1 - 2a) exp(-a), a = (pi f (t - t0))^2.",
          .keys = {choice("shape", {"ricker"}, "Shape of the pulse."),
                   {.name = "frequency",
                    .unit = "Hz",
                    .meaning = "Central frequency f.",
                    .required = true,
                    .range = {.low = 1e-3, .high = 1e3}},
                   {.name = "time",
                    .unit = "s",
                    .meaning = "Time t0 of the peak.",
                    .required = true,
                    .range = {.low = -1e4, .high = 1e4}},
                   {.name = "velocity", .unit = "m/s", .meaning = "Peak velocity V.", .required = true}}};
}

} // namespace

std::vector<Table> motion_tables() {
  Table motion{.name = "motion",
               .required = true,
               .meaning = "The incident plane wave: a `pulse` or the record in a `file`, never both.",
               .keys = record_keys()};
  append(motion.keys, wave_keys());
  append(motion.keys, way_keys());
  Table vertical{.name = "motion.vertical",
                 .meaning =
                     "The vertical component of the shaking: a P wave that comes up beside the SV wave "
                     "of [motion], a `pulse` or the record in a `file`, of the same kind. Both waves "
                     "add up; on a shaking table it is the motion along y.",
                 .keys = record_keys()};
  append(vertical.keys, way_keys());
  vertical.keys.back().otherwise = "that of [motion]";
  return {motion, pulse_table("motion.pulse"), vertical, pulse_table("motion.vertical.pulse")};
}

std::vector<Table> stage_motion_tables() {
  return {{.name = "stage.motion",
           .meaning =
               "The motion of a shaking after the first one, of which [motion] is: a `pulse` or the record "
               "in a `file`, of the same kind, wave, angle and reference. Its time 0 is the start of the "
               "stage.",
           .keys = record_keys()},
          pulse_table("stage.motion.pulse"),
          {.name = "stage.motion.vertical",
           .meaning = "The vertical component of this shaking, as [motion.vertical] of the first one, whose "
                      "angle and reference it has.",
           .keys = record_keys()},
          pulse_table("stage.motion.vertical.pulse")};
}

} // namespace tremolo::scene
