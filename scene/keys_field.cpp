#include "scene/keys_field.hpp"

#include "scene/keys_elastic.hpp"

namespace tremolo::scene {

namespace {

Table motion() {
  return {
      .name = "motion",
      .required = true,
      .meaning = "The incident plane wave: a `pulse` or the record in a `file`, never both.",
      .keys = {
          {.name = "file",
           .type = Type::text,
           .meaning =
               "Record in PEER format, relative to the case file: accelerations in g (AT2) or velocities in "
               "cm/s (VT2). Accelerations are integrated by the trapezoidal rule. The velocity rises with a "
               "half "
               "cosine over the first 0.1 s, falls with a half cosine to zero within 1 s after the last "
               "sample, "
               "and is joined by a cubic spline; it is zero before and after.",
           .otherwise = "`pulse`"},
          {.name = "quantity",
           .type = Type::choice,
           .meaning = "What the file holds; only with `file`.",
           .fallback = "acceleration",
           .choices = {"acceleration", "velocity"}},
          {.name = "scale",
           .unit = "1",
           .meaning = "Factor on the record; only with `file`.",
           .fallback = "1"},
          choice("wave", {"SV", "P"}, "Type of the incident wave."),
          {.name = "angle_deg",
           .unit = "degrees",
           .meaning = "Angle of incidence from the vertical, travelling to +x, +y.",
           .required = true,
           .range = {.low = 0.0, .high = 90.0, .high_open = true}},
          {.name = "reference",
           .type = Type::numbers,
           .unit = "m",
           .meaning = "Where the incident wave alone has exactly this motion along its polarisation: SV "
                      "(cos, -sin), P "
                      "(sin, cos) of the angle.",
           .required = true,
           .count = 2,
           .form = "[x, y]"},
      }};
}

Table pulse() {
  return {.name = "motion.pulse",
          .meaning = "Ricker velocity pulse V (1 - 2a) exp(-a), a = (pi f (t - t0))^2.",
          .keys = {
              choice("shape", {"ricker"}, "Shape of the pulse."),
              {.name = "frequency",
               .unit = "Hz",
               .meaning = "Central frequency f.",
               .required = true,
               .range = positive},
              {.name = "time", .unit = "s", .meaning = "Time t0 of the peak.", .required = true},
              {.name = "velocity", .unit = "m/s", .meaning = "Peak velocity V.", .required = true},
          }};
}

Table lateral(std::string_view name, std::string_view meaning) {
  return {.name = name,
          .required = true,
          .meaning = meaning,
          .keys = {
              choice("model", {"wave", "column"},
                     "Free-field model: exact plane waves in the half-space (any angle), or a "
                     "one-dimensional column "
                     "(vertical incidence, layers)."),
              {.name = "surface",
               .unit = "m",
               .meaning = "y of the free surface on this side; the soil of the model must reach up to it.",
               .otherwise = "`[surface] level`"},
          }};
}

Table base() {
  return {.name = "boundary.base",
          .required = true,
          .meaning = "What enters through the base.",
          .keys = {
              choice("model", {"wave", "column"}, "Free-field model, as for the sides."),
              choice("form", {"total", "incident"},
                     "`total`: velocity and stress of the whole free field, exact at any angle; needs the "
                     "same surface "
                     "level on both sides. `incident`: the incident wave alone, dashpots take up what comes "
                     "down again; "
                     "exact at vertical incidence, about 3 % off at 15 degrees and 16 % at 30 degrees.",
                     "total"),
          }};
}

} // namespace

std::vector<Table> field_keys() {
  return {
      motion(),
      pulse(),
      {.name = "surface",
       .required = true,
       .meaning = "The free surface of the free field.",
       .keys = {{.name = "level", .unit = "m", .meaning = "y of the free surface.", .required = true}}},
      {.name = "halfspace",
       .required = true,
       .meaning =
           "The homogeneous half-space below the profile, up to the surface where there is no `[[profile]]`. "
           "Either `young` and `poisson`, or `vs` and `vp`.",
       .keys = elastic_keys()},
      {.name = "profile",
       .kind = Kind::array,
       .meaning = "Layers of the columns from the surface down; the half-space continues below the last one. "
                  "Only where "
                  "every side and the base have `model = \"column\"`.",
       .keys = with_elastic_keys({
           {.name = "thickness",
            .unit = "m",
            .meaning = "Thickness of the layer.",
            .required = true,
            .range = positive},
           {.name = "damping_ratio",
            .unit = "1",
            .meaning = "Fraction of critical damping.",
            .otherwise = "`[damping] ratio`",
            .range = {.low = 0.0, .high = 1.0, .high_open = true}},
       })},
      {.name = "damping",
       .meaning = "Material damping of the columns.",
       .keys =
           {choice(
                "model", {"none", "rayleigh", "kelvin_voigt"},
                "`rayleigh`: the ratio at two frequencies; `kelvin_voigt`: the ratio at one, proportional to "
                "frequency.",
                "none"),
            {.name = "ratio",
             .unit = "1",
             .meaning = "Fraction of critical damping of layers that have none of their own.",
             .fallback = "0",
             .range = {.low = 0.0, .high = 1.0, .high_open = true},
             .when = {"model", {"rayleigh", "kelvin_voigt"}}},
            {.name = "frequencies",
             .type = Type::numbers,
             .unit = "Hz",
             .meaning = "The two frequencies at which Rayleigh damping has the ratio.",
             .required = true,
             .range = positive,
             .count = 2,
             .form = "[f1, f2]",
             .when = {"model", {"rayleigh"}}},
            {.name = "reference_frequency",
             .unit = "Hz",
             .meaning = "The frequency at which Kelvin-Voigt damping has the ratio.",
             .required = true,
             .range = positive,
             .when = {"model", {"kelvin_voigt"}}}}},
      {.name = "column",
       .meaning = "Numerics of the columns.",
       .keys = {choice("integrator", {"central_difference", "newmark"},
                       "Explicit central differences, or implicit Newmark (1/4, 1/2).", "central_difference"),
                {.name = "element_size",
                 .unit = "m",
                 .meaning = "Largest finite element.",
                 .otherwise = "`[mesh] size`",
                 .range = positive},
                {.name = "dt",
                 .unit = "s",
                 .meaning = "Time step of the column.",
                 .otherwise = "chosen by the column",
                 .range = positive}}},
      {.name = "boundary",
       .required = true,
       .meaning = "Which free field drives each side, and how.",
       .keys = {}},
      lateral("boundary.left", "Free field at the left side."),
      lateral("boundary.right", "Free field at the right side."),
      base(),
  };
}

} // namespace tremolo::scene
