#include "scene/keys/keys_field.hpp"

#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"

namespace tremolo::scene {

namespace {

constexpr std::string_view models_meaning =
    "Who computes the free field. `wave`: plane waves in layers, exact, any "
    "angle. `fe`: finite-element column of soil and water, any law, any angle below the first critical one. "
    "`ode`: "
    "column by the method of lines with error control. `eql`: "
    "equivalent-linear layers. `recording`: served again from a `file`. "
    "`external`: a program of your own. `mpm`: a "
    "periodic column of the domain's own cells.";

/// The models that a base on ground may have.
std::vector<std::string_view> models_of_ground() {
  auto models = all_words<SourceModel>();
  std::erase(models, name(SourceModel::shaking_table));
  return models;
}

std::vector<Key> field_model() {
  return {
      {.name = "model",
       .type = Type::choice,
       .meaning = models_meaning,
       .required = true,
       .choices = models_of_ground()},
      {.name = "file",
       .type = Type::text,
       .meaning = "The recorded free field, relative to the case file.",
       .required = true,
       .when = {"model", {name(SourceModel::recording)}}},
      {.name = "side",
       .type = Type::choice,
       .meaning =
           "In the recorded exchange of a run (`exchange.h5`), the side whose free field is served again.",
       .otherwise = "`file` is the recording of a free field alone",
       .choices = all_words<Side>(),
       .when = {"model", {name(SourceModel::recording)}}},
      {.name = "program",
       .type = Type::text,
       .meaning = "The program that serves the free field, relative to the case file.",
       .required = true,
       .when = {"model", {name(SourceModel::external)}}}};
}

Key absorber() {
  return choice<Absorber>(
      "absorber",
      "What takes up waves that leave the model here, that is, what differs from the free field. "
      "`dashpots`: those of Eq. (6), good near the normal; 11 % of the energy of SV waves come back at 60 "
      "degrees. `matched_layer`: a perfectly matched layer of `[mesh] layer_cells` behind the boundary, less "
      "than 1 % up to 60 degrees; at a base whose `form` is \"total\" or \"blended\", since under "
      "\"incident\" the free field's own waves come down into it, which it does not know.",
      Absorber::dashpots);
}

/// Beside dashpots.
std::vector<Key> springs() {
  const Condition beside_dashpots{"absorber", {name(Absorber::dashpots)}};
  return {
      {.name = "spring",
       .type = Type::numbers_or_false,
       .unit = "1",
       .meaning =
           "a_n and a_t of springs beside the dashpots, k = a G/R across and along the face, with R the "
           "distance from `spring_centre`: they hold the weight that comes to bear elsewhere after the model "
           "was at rest, and pull on the displacement against the free field. `false`: dashpots alone, which "
           "hold no static force.",
       .otherwise =
           "`[1.0, 0.5]`; `[0.5, 0.25]` where the sides' surfaces or layers differ, where the base has "
           "them behind a lag",
       .range = {.low = 0.0},
       .count = 2,
       .form = "[a_n, a_t]",
       .when = beside_dashpots},
      {.name = "spring_centre",
       .type = Type::numbers,
       .unit = "m",
       .meaning =
           "The point that loads come from: springs are softer the farther they are from it. Within two "
           "cells they grow no stiffer.",
       .otherwise =
           "on the ground's surface in the middle of all `[[structure]]`s; without any, in the middle "
           "of the box at the mean of both surfaces",
       .count = 2,
       .form = "[x, y]",
       .when = beside_dashpots}};
}

void add_absorber(std::vector<Key>& keys) {
  keys.push_back(absorber());
  for (Key& key : springs())
    keys.push_back(std::move(key));
}

Key sides() {
  return choice<Sides>(
      "sides",
      "What the sides are. `free_field`: each is driven by its free field. `periodic`: they are "
      "one, and the model "
      "repeats itself beyond them; for vertical incidence, exact. `periodic_springs`: the same by "
      "stiff springs "
      "between the particles of both sides, an error of first order in the cell size. `container`: smooth "
      "walls that stand on a shaking table; soil slides along them and does not part from them.",
      Sides::free_field);
}

Table lateral(std::string_view name, std::string_view meaning) {
  auto keys = field_model();
  keys.push_back({.name = "surface",
                  .unit = "m",
                  .meaning = "y of the free surface on this side; the soil of the model must reach up to it.",
                  .otherwise = "`[surface] level`"});
  add_absorber(keys);
  return {.name = name, .meaning = meaning, .keys = std::move(keys)};
}

Table own_profile(std::string_view name) {
  return {.name = name,
          .kind = Kind::array,
          .meaning =
              "Layers of this side alone, from its surface down, instead of `[[profile]]`; the same keys.",
          .keys = layer_keys()};
}

Table base() {
  auto keys = field_model();
  keys.front().meaning =
      "Who computes the free field, as for the sides; or `shaking_table`: a rigid base that moves as "
      "`[motion]` "
      "says, `kind = \"within\"`, along x for SV and along y for P. It goes with the sides `container` and "
      "`periodic`, and without `[surface]`, `[halfspace]` and `[[profile]]`.";
  keys.front().choices = all_words<SourceModel>();
  keys.push_back(choice<BaseForm>(
      "form",
      "`total`: velocity and stress of the whole free field, exact at any angle; needs the same "
      "surface level and layers on both sides. `blended`: the total fields of both sides, each under its own "
      "surface and layers, blended linearly from the left side to the right one; the same as `total` where "
      "they are equal, best where they differ, with matched layers on all sides and room. `incident`: the "
      "incident wave alone, dashpots take up what comes down again; needs a base in the half-space or at its "
      "top; exact at vertical incidence, in uniform ground 3 % off at 15 degrees and 16 % at 30 degrees.",
      BaseForm::blended));
  const auto form = keys.size() - 1;
  add_absorber(keys);
  for (auto key = form; key < form + 2; ++key) // form and absorber
    keys[key].when = {"model", models_of_ground()};
  return {.name = "boundary.base",
          .required = true,
          .meaning = "What enters through the base.",
          .keys = std::move(keys)};
}

} // namespace

std::vector<Table> boundary_keys() {
  return {
      {.name = "boundary",
       .required = true,
       .meaning = "Which free field drives each side, and how.",
       .keys = {sides()}},
      lateral("boundary.left",
              "Free field at the left side. Required unless `[boundary] sides` are periodic."),
      own_profile("boundary.left.profile"),
      lateral("boundary.right",
              "Free field at the right side. Required unless `[boundary] sides` are periodic."),
      own_profile("boundary.right.profile"),
      base(),
  };
}

} // namespace tremolo::scene
