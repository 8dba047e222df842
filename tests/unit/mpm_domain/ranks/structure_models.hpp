#pragma once

// Structures in the box of 100 m by 40 m whose bits are compared.

#include "tests/support/box_models.hpp"
#include "tests/support/structure_scene.hpp"
#include "tests/support/wet_lining.hpp"

namespace tremolo::test_support {

inline mpm_domain::Structure& add_block(mpm_domain::Spec& spec, const char* name, std::vector<Vector> outline,
                                        double density = 1800.0) {
  spec.gravity = 9.81;
  spec.structures.push_back(structure(std::move(outline), density, 0.5));
  spec.structures.back().name = name;
  return spec.structures.back();
}

inline void add_building(mpm_domain::Spec& spec) {
  yield(spec);
  add_block(spec, "building", rectangle(26.0, -4.0, 38.0, 6.0));
}

/// Nodes of its contact are nodes of the boundary too.
inline void add_building_at_side(mpm_domain::Spec& spec) {
  yield(spec);
  add_block(spec, "building", rectangle(1.0, -4.0, 7.0, 4.0));
}

/// A rigid one and two elastic ones that touch each other, one of them with a load.
inline void add_neighbours(mpm_domain::Spec& spec) {
  add_block(spec, "rigid", rectangle(26.0, -3.0, 32.0, 5.0));
  add_block(spec, "elastic", rectangle(32.0, -3.0, 37.0, 5.0)).stiffness = mpm_domain::Stiffness{2e8, 0.2};
  add_block(spec, "roof", rectangle(27.0, 5.0, 36.0, 7.0)).stiffness = mpm_domain::Stiffness{2e8, 0.2};
  spec.structure_loads = {{.structure = "elastic", .force = {1e4, -2e4}}};
}

/// Two walls with a strut, and an anchor in the ground.
inline void add_propped_walls(mpm_domain::Spec& spec) {
  add_block(spec, "left", rectangle(40.0, -6.0, 42.0, 3.0));
  add_block(spec, "right", rectangle(50.0, -6.0, 52.0, 3.0));
  spec.props.push_back(
      {.name = "strut", .from = {"left", {42.0, 2.0}}, .to = {"right", {50.0, 2.0}}, .stiffness = 1e6});
  spec.props.push_back(
      {.name = "anchor", .from = {"right", {52.0, -2.0}}, .to = {"", {75.0, -20.0}}, .stiffness = 1e6});
}

/// Loads on the surface, one of which grows.
inline void add_surface_loads(mpm_domain::Spec& spec) {
  spec.gravity = 9.81;
  spec.loads = {
      {.x_min = 20.0, .x_max = 40.5, .pressure = 2e4, .shear = 1e3},
      {.x_min = 60.0, .x_max = 62.0, .pressure = 5e4, .shear = 0.0, .growth = mpm_domain::Growth{0.9, 0.2}}};
}

inline void add_lining(mpm_domain::Spec& spec) {
  spec.gravity = 9.81;
  spec.linings = {concrete_lining({50.0, -15.0}, 0.6)};
}

/// A light box under the water table.
inline void add_wet_box(mpm_domain::Spec& spec) {
  add_water(spec, materials::Drainage::coupled);
  add_block(spec, "box", rectangle(44.0, -30.0, 52.0, -22.0), 500.0);
}

} // namespace tremolo::test_support
