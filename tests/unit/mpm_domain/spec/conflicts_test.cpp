// The domain refuses each pair of features that the table of conflicts has.

#include "mpm_domain/spec/conflicts.hpp"

#include "mpm_domain/domain.hpp"
#include "tests/support/box_run.hpp"

#include <gmock/gmock.h>

#include <map>
#include <stdexcept>
#include <string_view>

namespace tremolo::mpm_domain {
namespace {

/// What gives a spec each feature.
const std::map<std::string_view, void (*)(Spec& spec)> features{
    {"'transfer' = \"flip\"", [](Spec& spec) { spec.scheme.transfer = Transfer::flip; }},
    {"'order' = \"usl\"", [](Spec& spec) { spec.scheme.order = StepOrder::usl; }},
    {"'subcycle' = true", [](Spec& spec) { spec.scheme.subcycle = true; }},
    {"'dispersion' = \"reduced\"", [](Spec& spec) { spec.scheme.dispersion = Dispersion::reduced; }},
    {"'particles_per_cell' = 1", [](Spec& spec) { spec.particles_per_cell = 1; }},
    {"'particle_boxes' = \"deforming\"", [](Spec& spec) { spec.boxes = ParticleBoxes::deforming; }},
    {"cells of one size", [](Spec& spec) { spec.refine.clear(); }},
    {"cells of several sizes",
     [](Spec& spec) {
       spec.refine = {{{1.0, 1.0, 3.0, 3.0}, 1}};
     }},
    {"'sides' = \"free_field\"", [](Spec& spec) { spec.sides = Sides::free_field; }},
    {"'sides' = \"periodic_springs\"", [](Spec& spec) { spec.sides = Sides::periodic_springs; }},
    {"'sides' = \"container\"", [](Spec& spec) { spec.sides = Sides::container; }},
    {"a shaking table", [](Spec& spec) { spec.rigid_base = true; }},
    {"a base on ground", [](Spec& spec) { spec.rigid_base = false; }},
    {"a matched layer", [](Spec& spec) { spec.matched_sides = {Side::base}; }},
    {"ground water", [](Spec& spec) { spec.water.emplace(); }},
    {"structures", [](Spec& spec) { spec.structures.emplace_back(); }},
    {"linings", [](Spec& spec) { spec.linings.emplace_back(); }},
    {"loads on the surface",
     [](Spec& spec) {
       spec.loads = {{1.0, 2.0, 1e3}};
     }},
    {"constructions after a shaking", [](Spec& spec) { spec.earthworks.emplace_back(); }},
};

TEST(Conflicts, AreRefusedByTheDomain) {
  EXPECT_NO_THROW(Domain{test_support::elastic_box(4.0, 4.0, 1.0)});
  for (const Conflict& conflict : all_conflicts()) {
    Spec spec = test_support::elastic_box(4.0, 4.0, 1.0);
    features.at(conflict.feature.text)(spec);
    features.at(conflict.other.text)(spec);
    try {
      Domain{spec};
      ADD_FAILURE() << conflict.text();
    } catch (const std::invalid_argument& refusal) {
      EXPECT_THAT(refusal.what(), testing::HasSubstr(conflict.text()));
    }
  }
}

} // namespace
} // namespace tremolo::mpm_domain
