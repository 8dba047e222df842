#include "scene/keys/keys_model.hpp"

#include "mesh/quadtree.hpp"
#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"
#include "scene/keys/soil/keys_soil.hpp"
#include "scene/keys/soil/keys_water.hpp"
#include "scene/keys/stages/keys_motion.hpp"
#include "scene/keys/stages/keys_stage.hpp"
#include "scene/keys/structure/keys_structure.hpp"

#include <algorithm>
#include <array>

namespace tremolo::scene {

namespace {

Table time() {
  return {
      .name = "time",
      .meaning = "Time stepping of the domain.",
      .keys = {
          {.name = "fraction",
           .unit = "1",
           .meaning = "Time step as a fraction of the critical step 0.65 h/c_p; at most 0.85 with `order = "
                      "\"usl\"`.",
           .fallback = "0.5",
           .range = {.low = 0.0, .high = 1.0, .low_open = true}},
          {.name = "dt",
           .unit = "s",
           .meaning = "A fixed time step instead of `fraction`, with the same limits.",
           .otherwise = "from `fraction`",
           .range = above_zero},
          choice<Transfer>(
              "transfer", "How velocity travels between particles and grid: affine particle-in-cell or FLIP.",
              Transfer::apic),
          choice<StepOrder>(
              "order",
              "The velocity that strains the soil: `usl` takes the one that the step gives the nodes, "
              "`musl` maps the particles' new velocity to the nodes once more.",
              StepOrder::musl),
          {.name = "subcycle",
           .type = Type::boolean,
           .meaning = "Each level of a refined mesh takes a step of its own, half of the next coarser one's; "
                      "`fraction` and `dt` are then of the coarsest. See docs/subcycling.md.",
           .fallback = "false"}}};
}

Table refine() {
  return {
      .name = "refine",
      .kind = Kind::array,
      .meaning = "Where cells are finer than `size` of the mesh, see docs/mesh.md. Neighbouring cells differ "
                 "by one level at most: cells around a box are cut by themselves where that needs it. "
                 "Particles go with their cells, `particles_per_cell` of each.",
      .keys = {{.name = "box",
                .type = Type::numbers,
                .unit = "m",
                .meaning = "Every cell that overlaps it is cut. One that reaches an edge of the mesh's box "
                           "goes on beyond it.",
                .required = true,
                .count = 4,
                .form = "[x_min, y_min, x_max, y_max]"},
               {.name = "level",
                .type = Type::integer,
                .unit = "1",
                .meaning = "Cells there are 2^level times smaller than `size` of the mesh, or smaller still "
                           "where another box says so.",
                .required = true,
                .range = {.low = 1.0, .high = mesh::finest_level_allowed}}}};
}

/// Keys that a profile over depth may have besides K0. Sand in which stiffness and strength follow the
/// pressure by the law has none.
constexpr std::array<std::string_view, 11> vary_over_depth = {"young",
                                                              "vs",
                                                              "vp",
                                                              "cohesion_peak",
                                                              "cohesion_residual",
                                                              "cohesion",
                                                              "undrained_strength",
                                                              "shear_strength",
                                                              "reference_strain",
                                                              "mean_stress",
                                                              "overconsolidation_ratio"};

/// Keys of soils in a case; in a soil test the initial stresses are given by the test.
std::vector<Key> soil_keys_of_a_case() {
  auto keys = soil_keys();
  for (Key& key : keys)
    key.over_depth = std::ranges::find(vary_over_depth, key.name) != vary_over_depth.end();
  keys.push_back({.name = "rest_coefficient",
                  .unit = "1",
                  .meaning =
                      "Horizontal over vertical stress before shaking, K0, in the domain and in columns. "
                      "The gravity stage begins with it.",
                  .otherwise = "poisson/(1 - poisson)",
                  .range = {.low = 0.0, .high = 10.0, .low_open = true},
                  .over_depth = true});
  keys.push_back({.name = "damping",
                  .unit = "1",
                  .meaning =
                      "Fraction of critical damping at small strain, in the domain and in layers that name "
                      "the soil; what its law dissipates comes on top. [damping] says what it is at which "
                      "frequency.",
                  .otherwise = "`[damping] ratio`",
                  .range = {.low = 0.0, .high = 1.0, .high_open = true}});
  for (Key& key : pore_keys())
    keys.push_back(std::move(key));
  return keys;
}

} // namespace

std::vector<Table> model_keys() {
  std::vector<Table> tables = {
      {.name = "soil",
       .kind = Kind::named,
       .required = true,
       .meaning = soil_meaning,
       .keys = soil_keys_of_a_case()},
      water_table(),
      {.name = "region",
       .kind = Kind::array,
       .required = true,
       .meaning =
           "A polygon filled with one soil. Polygons that are there at the same time may touch but not "
           "overlap.",
       .keys = {{.name = "soil", .type = Type::text, .meaning = "Name of a `[soil.NAME]`.", .required = true},
                {.name = "name",
                 .type = Type::text,
                 .meaning = "By which construction stages call it. Several regions may share a name.",
                 .otherwise = "no stage places or removes it"},
                {.name = "polygon",
                 .type = Type::polygon,
                 .unit = "m",
                 .meaning = "Corners in either sense of rotation, inside the box of the mesh.",
                 .required = true}}},
      {.name = "mesh",
       .required = true,
       .meaning = "Background grid and particles.",
       .keys =
           {{.name = "size", .unit = "m", .meaning = "Cell size h.", .required = true, .range = above_zero},
            {.name = "box",
             .type = Type::numbers,
             .unit = "m",
             .meaning =
                 "The model; its left, right and lower edges are the boundaries. Its width is a multiple "
                 "of `size`, its height of the particle spacing. The grid is padded beyond it by itself.",
             .required = true,
             .count = 4,
             .form = "[x_min, y_min, x_max, y_max]"},
            {.name = "particles_per_cell",
             .type = Type::integer,
             .unit = "1",
             .meaning = "Particles per cell in each direction.",
             .fallback = "2",
             .range = {.low = 1.0, .high = 4.0}},
            choice<ParticleBoxes>(
                "particle_boxes",
                "Boxes over which particles see the grid. `fixed`: they keep their size, which is exact "
                "while strains are small; soil stretched by tens of per cent is no longer tiled by them and "
                "breaks into pieces in the end. `deforming`: they follow the soil, up to two cells "
                "wide. See docs/mesh.md.",
                ParticleBoxes::fixed),
            choice<Dilatation>(
                "dilatation",
                "The change of volume that laws of soil that yields see. `cell`: the mean of the particles "
                "of their cell, so that soil that yields at constant volume does not lock. `particle`: "
                "their own, cheaper and far too strong where soil is nearly incompressible. See "
                "docs/theory.md.",
                Dilatation::cell),
            choice<Dispersion>(
                "dispersion",
                "How much slower waves are than true ones, the shorter the slower. `plain`: as on any grid "
                "of "
                "this kind. `reduced`: the leading term is taken away, so that waves need about half as many "
                "cells; for elastic and hysteretic soil on cells of one size. See docs/dispersion.md.",
                Dispersion::plain),
            choice<ContactNormals>(
                "contact_normals",
                "Where the normal at a node between soil and a `[[structure]]` comes from. `polygon`: from "
                "the "
                "structure's surface. `gradient`: from the soil's volume around the node, so that pressure "
                "of "
                "pore water has no part along the surface; from the structure where the ground ends beside "
                "it. "
                "`automatic`: `gradient` where soil has a pore pressure, `polygon` elsewhere. See "
                "docs/structures.md.",
                ContactNormals::automatic),
            {.name = "layer_cells",
             .type = Type::integer,
             .unit = "cells",
             .meaning = "Depth of matched layers behind the box, where `[boundary]` asks for them.",
             .fallback = "10",
             .range = {.low = 4.0, .high = 200.0}}}},
      refine(),
      time(),
      stage_table(),
  };
  for (const Table& table : stage_motion_tables())
    tables.push_back(table);
  const auto structures = structure_keys();
  const auto linings = lining_keys();
  const auto sections = section_keys();
  const auto props = prop_keys();
  for (const auto& group : {structures, sections, props, linings})
    tables.insert(std::ranges::find(tables, "mesh", &Table::name), group.begin(), group.end());
  return tables;
}

} // namespace tremolo::scene
