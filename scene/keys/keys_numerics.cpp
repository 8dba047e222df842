#include "scene/keys/keys_field.hpp"

#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"

namespace tremolo::scene {

namespace {

Table fe() {
  return {.name = "fe",
          .meaning = "Numerics of the finite-element column (`model = \"fe\"`).",
          .keys = {{.name = "element_size",
                    .unit = "m",
                    .meaning = "Largest finite element.",
                    .otherwise = "half of `[mesh] size`: the free field is then more exact than the domain",
                    .range = above_zero},
                   {.name = "dt",
                    .unit = "s",
                    .meaning = "Time step of the column.",
                    .otherwise = "chosen by the column",
                    .range = above_zero}}};
}

Table ode() {
  return {
      .name = "ode",
      .meaning = "Numerics of the column by the method of lines (`model = \"ode\"`, SUNDIALS).",
      .keys = {
          choice<OdeMethod>(
              "method",
              "CVODE Adams or BDF; ARKODE explicit Runge-Kutta, or implicit in the damping and explicit in "
              "the rest.",
              OdeMethod::erk),
          {.name = "relative_tolerance",
           .unit = "1",
           .meaning = "Relative tolerance of the local error.",
           .fallback = "1e-5",
           .range = {.low = 1e-13, .high = 1e-1}},
          {.name = "absolute_tolerance",
           .unit = "m/s",
           .meaning = "Absolute tolerance of the local error in particle velocity; in strain, divided by the "
                      "shear wave speed.",
           .fallback = "1e-8",
           .range = above_zero},
          {.name = "cell_size",
           .unit = "m",
           .meaning = "Largest cell.",
           .otherwise = "half of `[mesh] size`: the free field is then more exact than the domain",
           .range = above_zero}}};
}

Table eql() {
  return {
      .name = "eql",
      .meaning = "The equivalent-linear iteration (`model = \"eql\"`).",
      .keys = {{.name = "sublayer",
                .unit = "m",
                .meaning =
                    "Layers whose soil has curves are cut into equal ones no thicker than this: each has the "
                    "stiffness and damping of the strain at its middle.",
                .fallback = "1",
                .range = above_zero},
               {.name = "strain_ratio",
                .unit = "1",
                .meaning = "Effective over largest shear strain.",
                .fallback = "0.65",
                .range = {.low = 0.0, .high = 1.0, .low_open = true}},
               {.name = "tolerance",
                .unit = "1",
                .meaning = "Relative change of modulus and damping below which the iteration ends.",
                .fallback = "1e-3",
                .range = {.low = 0.0, .high = 1.0, .low_open = true, .high_open = true}},
               {.name = "iterations",
                .type = Type::integer,
                .unit = "1",
                .meaning = "At most so many.",
                .fallback = "50",
                .range = {.low = 1.0, .high = 1e6}},
               choice("unconverged", {"refuse", "allow"},
                      "What an iteration that has not converged is: an error, or served with a warning.",
                      "refuse")}};
}

} // namespace

std::vector<Table> numerics_keys() {
  return {fe(), ode(), eql()};
}

} // namespace tremolo::scene
