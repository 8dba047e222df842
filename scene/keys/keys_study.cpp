// Keys of studies.

#include "scene/keys/keys_study.hpp"

#include "scene/keys/soil/keys_elastic.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/study.hpp"

namespace tremolo::scene {

namespace {

Table study_top() {
  return {.name = "",
          .meaning = "Keys at the top of the file, before the first table.",
          .keys = {
              {.name = "title",
               .type = Type::text,
               .meaning = "One line that names the study.",
               .otherwise = "title of the case"},
              {.name = "case",
               .type = Type::text,
               .meaning = "Case file, relative to the study.",
               .required = true},
          }};
}

std::vector<std::string_view> computed_words() {
  std::vector<std::string_view> all;
  for (const SourceModel model : computed_models())
    all.push_back(name(model));
  return all;
}

Table study_column() {
  return {
      .name = "column",
      .meaning = "With this table each run is a site response, `tremolo column`, and none of a domain. The "
                 "case needs its ground and motion alone.",
      .keys = {{.name = "models",
                .type = Type::choices,
                .meaning = "Free-field models, as `--models` of `tremolo column`; each is a run of its own.",
                .required = true,
                .choices = computed_words()}}};
}

Table study_axes() {
  return {
      .name = "axes",
      .open = true,
      .meaning =
          "Keys of the case, each with the array of its values: `motion.angle_deg = [0, 15, 30]`. A "
          "key with one value is set for all runs. Names of files are relative to the study. Tables "
          "of an array are counted from 0: `\"region[0].soil\" = [\"sand\", \"clay\"]`. In a Latin "
          "hypercube a number may have a range instead, `soil.sand.young = { low = 20e6, high = "
          "60e6, scale = \"log\" }`, `scale` being `linear` where it is left out. `{ count = 30 }` stands "
          "for the array of the whole numbers from 1 to 30, as of `random_profile.realisation`."};
}

Table study_design() {
  const Condition sampled = {"kind", {name(SweepDesign::latin_hypercube)}};
  return {
      .name = "design",
      .meaning = "Which combinations of the values are run.",
      .keys = {
          choice<SweepDesign>("kind",
                              "`product`: every combination. `list`: the first values of all keys together, "
                              "then the second ones, and so on. `latin_hypercube`: `samples` runs, in which "
                              "each range and each array is covered evenly: of n runs, one lies in each "
                              "n-th of a range.",
                              SweepDesign::product),
          {.name = "samples",
           .type = Type::integer,
           .unit = "1",
           .meaning = "Number of runs.",
           .required = true,
           .range = {.low = 1.0, .high = 100000.0},
           .when = sampled},
          {.name = "seed",
           .type = Type::integer,
           .unit = "1",
           .meaning = "It begins the random numbers; equal seeds give equal runs.",
           .fallback = "1",
           .range = {.low = 0.0, .high = 4294967295.0},
           .when = sampled},
      }};
}

Table study_motions() {
  return {.name = "motions",
          .meaning =
              "Motions made from one recipe with several seeds, as `tremolo motion --synthesise` makes "
              "them; they become values of `motion.file`.",
          .keys = {
              {.name = "recipe",
               .type = Type::text,
               .meaning = "Recipe, relative to the study. The search for the first motion begins with its "
                          "seed, that for each other one behind the seed of the one before.",
               .required = true},
              {.name = "count",
               .type = Type::integer,
               .unit = "1",
               .meaning = "Number of motions.",
               .required = true,
               .range = {.low = 1.0, .high = 10000.0}},
          }};
}

Table study_measures() {
  return {
      .name = "measures",
      .meaning =
          "This table adds measures to those that the runs hold anyway, and chooses what the pictures show.",
      .keys = {
          {.name = "failure_strain",
           .unit = "1",
           .meaning = "Equivalent plastic strain of a shear band, as in `tremolo failure`.",
           .fallback = "0.1",
           .range = above_zero},
          choice<Intensity>("intensity",
                            "Measure of the incident motion over which responses are drawn: peak "
                            "acceleration, peak velocity, or Arias intensity.",
                            Intensity::pgv),
          {.name = "colour",
           .type = Type::text,
           .meaning = "The key of [axes] whose values have a colour each in the pictures; the first one is "
                      "what the others are compared with.",
           .otherwise = "`model` of several models; `motion.angle_deg`; or else the first array of more than "
                        "one value that is neither `motion.file` nor `random_profile.realisation`"},
          {.name = "draw",
           .type = Type::texts,
           .meaning = "Measures that the pictures show, by their names in `sweep.csv`, such as "
                      "`\"crest.final_displacement_m\"`.",
           .otherwise = "six at most of those that are not the same in all runs"},
      }};
}

Table spectral_ratio() {
  return {.name = "measures.spectral_ratio",
          .meaning = "Ratio of the horizontal response spectra at two monitors, 5 % damping.",
          .keys = {
              {.name = "of", .type = Type::text, .meaning = "Name of a [[monitor]].", .required = true},
              {.name = "over",
               .type = Type::text,
               .meaning = "Name of the [[monitor]] that it is divided by.",
               .required = true},
              {.name = "periods",
               .type = Type::series,
               .unit = "s",
               .meaning = "Periods of the oscillators.",
               .required = true,
               .range = {.low = 0.01, .high = 10.0}},
          }};
}

} // namespace

KeyTable study_keys() {
  static const std::vector<Table> tables = {study_top(),     study_column(),  study_axes(),
                                            study_design(),  study_motions(), study_measures(),
                                            spectral_ratio()};
  return tables;
}

const Table& range_keys() {
  static const Table table = {
      .name = "axes",
      .meaning = "A range of a number.",
      .keys = {{.name = "low", .meaning = "Lower end.", .required = true},
               {.name = "high", .meaning = "Upper end.", .required = true},
               choice<RangeScale>("scale", "Even on this scale.", RangeScale::linear)}};
  return table;
}

const Table& count_keys() {
  static const Table table = {.name = "axes",
                              .meaning = "The whole numbers from 1 on.",
                              .keys = {{.name = "count",
                                        .type = Type::integer,
                                        .meaning = "How many.",
                                        .required = true,
                                        .range = {.low = 1.0, .high = 10000.0}}}};
  return table;
}

} // namespace tremolo::scene
