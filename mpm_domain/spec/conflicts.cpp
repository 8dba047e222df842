#include "mpm_domain/spec/conflicts.hpp"

#include "mpm_domain/spec/spec.hpp"

#include <array>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

constexpr Feature flip{"'transfer' = \"flip\"", "time.transfer",
                       [](const auto& m) { return m.scheme.transfer == Transfer::flip; }};
constexpr Feature usl{"'order' = \"usl\"", "time.order",
                      [](const auto& m) { return m.scheme.order == StepOrder::usl; }};
constexpr Feature subcycling{"'subcycle' = true", "time.subcycle",
                             [](const auto& m) { return m.scheme.subcycle; }};
constexpr Feature reduced_dispersion{"'dispersion' = \"reduced\"", "mesh.dispersion", [](const auto& m) {
                                       return m.scheme.dispersion == Dispersion::reduced;
                                     }};
constexpr Feature single_particles{"'particles_per_cell' = 1", "mesh.particles_per_cell",
                                   [](const auto& m) { return m.particles_per_cell == 1; }};
constexpr Feature deforming_boxes{"'particle_boxes' = \"deforming\"", "mesh.particle_boxes",
                                  [](const auto& m) { return m.boxes == ParticleBoxes::deforming; }};
constexpr Feature equal_cells{"cells of one size", "refine", [](const auto& m) { return !m.levels; }};
constexpr Feature levels{"cells of several sizes", "refine", [](const auto& m) { return m.levels; }};
constexpr Feature free_field_sides{"'sides' = \"free_field\"", "boundary.sides",
                                   [](const auto& m) { return m.sides == Sides::free_field; }};
constexpr Feature springs_between_sides{"'sides' = \"periodic_springs\"", "boundary.sides",
                                        [](const auto& m) { return m.sides == Sides::periodic_springs; }};
constexpr Feature container{"'sides' = \"container\"", "boundary.sides",
                            [](const auto& m) { return m.sides == Sides::container; }};
constexpr Feature shaking_table{"a shaking table", "boundary.base.model",
                                [](const auto& m) { return m.rigid_base; }};
constexpr Feature ground_below{"a base on ground", "boundary.base.model",
                               [](const auto& m) { return !m.rigid_base; }};
constexpr Feature matched_layer{"a matched layer", "boundary", [](const auto& m) { return m.matched_layer; }};
constexpr Feature water{"ground water", "", [](const auto& m) { return m.water; }};
constexpr Feature structures{"structures", "", [](const auto& m) { return m.structures; }};
constexpr Feature linings{"linings", "", [](const auto& m) { return m.linings; }};
constexpr Feature surface_loads{"loads on the surface", "", [](const auto& m) { return m.surface_loads; }};
constexpr Feature earthworks{"constructions after a shaking", "", [](const auto& m) { return m.earthworks; }};

constexpr std::string_view own_velocity =
    "contact changes the velocity that particles take from the grid, and under \"flip\" they keep their own; "
    "use \"apic\"";
constexpr std::string_view one_step =
    "a body answers to all the soil that it touches in one step, the same for all levels; leave it out";
constexpr std::string_view no_rest = "what rests on sharpened soil does not stay at rest; use \"plain\"";
constexpr std::string_view not_studied = "their inertia there was not studied";
constexpr std::string_view carries =
    "it carries a container or ground that repeats itself; use \"container\" or \"periodic\"";

constexpr std::array conflict_rows{
    Conflict{flip, structures, own_velocity},
    Conflict{flip, linings, own_velocity},
    Conflict{subcycling, structures, one_step},
    Conflict{subcycling, linings, one_step},
    Conflict{subcycling, equal_cells, "it gives levels steps of their own; add [[refine]], or leave it out"},
    Conflict{subcycling, flip, "use \"apic\""},
    Conflict{subcycling, usl, "use \"musl\""},
    Conflict{subcycling, springs_between_sides,
             "springs go by one step for all; use sides = \"free_field\" or \"periodic\""},
    Conflict{subcycling, water,
             "water flows between soil on all levels, and its fast waves allow the same short step wherever "
             "cells are equally fine; leave it out"},
    Conflict{subcycling, surface_loads, "leave it out"},
    Conflict{subcycling, earthworks, "leave it out"},
    Conflict{reduced_dispersion, flip,
             "the error of FLIP is its transfer's, which it does not touch; use \"apic\""},
    Conflict{reduced_dispersion, usl,
             "it sharpens the velocity that is mapped to the nodes once more; use \"musl\""},
    Conflict{reduced_dispersion, single_particles,
             "one particle a cell loses more of a wave in its transfer; take 2 to 4"},
    Conflict{reduced_dispersion, deforming_boxes, "it reads strains in boxes of its own; use \"fixed\""},
    Conflict{
        reduced_dispersion, levels,
        "its differences end where levels meet, and that costs more than finer cells gain; use \"plain\""},
    Conflict{reduced_dispersion, springs_between_sides, "use sides = \"free_field\" or \"periodic\""},
    Conflict{reduced_dispersion, shaking_table,
             "it was not studied at nodes that a shaking table holds; use \"plain\""},
    Conflict{reduced_dispersion, water,
             "the pressure of pore water would need differences of its own; use \"plain\""},
    Conflict{reduced_dispersion, structures, no_rest},
    Conflict{reduced_dispersion, linings, no_rest},
    Conflict{reduced_dispersion, earthworks, "use \"plain\""},
    Conflict{springs_between_sides, surface_loads, "use \"periodic\""},
    Conflict{free_field_sides, shaking_table, carries},
    Conflict{springs_between_sides, shaking_table, carries},
    Conflict{container, ground_below,
             "its walls stand on a shaking table; use [boundary.base] model = \"shaking_table\""},
    Conflict{shaking_table, matched_layer,
             "it moves as prescribed, whatever reaches it; leave the layer out"},
    Conflict{shaking_table, structures, not_studied},
    Conflict{shaking_table, linings, not_studied},
};

Combination combination_of(const Spec& spec) {
  return {.scheme = spec.scheme,
          .particles_per_cell = spec.particles_per_cell,
          .boxes = spec.boxes,
          .sides = spec.sides,
          .levels = !spec.refine.empty(),
          .rigid_base = spec.rigid_base,
          .matched_layer = !spec.matched_sides.empty(),
          .water = spec.water.has_value(),
          .structures = !spec.structures.empty(),
          .linings = !spec.linings.empty(),
          .surface_loads = !spec.loads.empty(),
          .earthworks = !spec.earthworks.empty()};
}

} // namespace

std::string Conflict::text() const {
  return std::string(feature.text).append(" does not go with ").append(other.text).append(": ").append(why);
}

std::span<const Conflict> all_conflicts() {
  return conflict_rows;
}

void refuse_conflicts(const Spec& spec) {
  const Combination model = combination_of(spec);
  std::string texts;
  for (const Conflict& conflict : conflict_rows)
    if (conflict.is_in(model))
      texts += (texts.empty() ? "" : ". ") + conflict.text();
  if (!texts.empty())
    throw std::invalid_argument(texts);
}

} // namespace tremolo::mpm_domain
