// The rule choices_go_together reports each pair of features that the table of conflicts has.

#include "../lining_case.hpp"
#include "rule_cases.hpp"

#include "mpm_domain/spec/conflicts.hpp"

#include <gmock/gmock.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string with_sides(const std::string& sides, const std::string& text) {
  return with("left = { model = \"wave\" }\nright = { model = \"wave\" }\n", "sides = \"" + sides + "\"\n",
              text);
}

std::string with_mesh_key(const std::string& key, const std::string& text) {
  return with("[mesh]\n", "[mesh]\n" + key + "\n", text);
}

/// What with_block() or with_ring() adds to the heavy case.
std::string addition(const std::string& text) {
  return text.substr(heavy().size());
}

/// What gives a case each feature; three the heavy case has already.
const std::map<std::string_view, std::string (*)(const std::string& text)> features{
    {"'transfer' = \"flip\"", [](const std::string& text) { return "time.transfer = \"flip\"\n" + text; }},
    {"'order' = \"usl\"", [](const std::string& text) { return "time.order = \"usl\"\n" + text; }},
    {"'subcycle' = true", [](const std::string& text) { return "time.subcycle = true\n" + text; }},
    {"'dispersion' = \"reduced\"",
     [](const std::string& text) { return with_mesh_key("dispersion = \"reduced\"", text); }},
    {"'particles_per_cell' = 1",
     [](const std::string& text) { return with_mesh_key("particles_per_cell = 1", text); }},
    {"'particle_boxes' = \"deforming\"",
     [](const std::string& text) { return with_mesh_key("particle_boxes = \"deforming\"", text); }},
    {"cells of one size", [](const std::string& text) { return text; }},
    {"cells of several sizes",
     [](const std::string& text) { return text + "[[refine]]\nbox = [5.0, -5.0, 15.0, 0.0]\nlevel = 1\n"; }},
    {"'sides' = \"free_field\"", [](const std::string& text) { return text; }},
    {"'sides' = \"periodic_springs\"",
     [](const std::string& text) { return with_sides("periodic_springs", text); }},
    {"'sides' = \"container\"", [](const std::string& text) { return with_sides("container", text); }},
    {"a shaking table",
     [](const std::string& text) {
       return with("base = { model = \"wave\", form = \"total\" }", "base = { model = \"shaking_table\" }",
                   text);
     }},
    {"a base on ground", [](const std::string& text) { return text; }},
    {"a matched layer",
     [](const std::string& text) {
       return with("base = { ", "base = { absorber = \"matched_layer\", ", text);
     }},
    {"ground water", [](const std::string& text) { return text + "[water]\nlevel = -2.0\n"; }},
    {"structures", [](const std::string& text) { return text + addition(with_block()); }},
    {"linings", [](const std::string& text) { return text + addition(with_ring()); }},
    {"loads on the surface",
     [](const std::string& text) {
       return with(
           "kind = \"shaking\"",
           "kind = \"load\"\nname = \"crane\"\nx_m = [4.0, 6.0]\npressure_pa = 1e3\n[[stage]]\nkind = "
           "\"shaking\"",
           text);
     }},
    {"constructions after a shaking",
     [](const std::string& text) {
       return with("0.0]\n[boundary]", "4.0]\n[boundary]", text) +
              "[[stage]]\nkind = \"construction\"\nname = \"repair\"\nplace = [\"fill\"]\nramp_s = "
              "2.0\n[[region]]\nsoil = \"sand\"\nname = \"fill\"\npolygon = [[11.0, 0.0], [15.0, 0.0], "
              "[14.0, "
              "2.0], [12.0, 2.0]]\n";
     }},
};

TEST(Rules, ChoicesGoTogether) {
  EXPECT_THAT(errors_of(heavy()), IsEmpty());
  for (const mpm_domain::Conflict& conflict : mpm_domain::all_conflicts()) {
    const std::vector<std::string> errors =
        errors_of(features.at(conflict.other.text)(features.at(conflict.feature.text)(heavy())));
    // The keys of a shaking table leave no place for a layer.
    EXPECT_THAT(errors, Contains(HasSubstr(conflict.other.text == "a matched layer"
                                               ? "'absorber' does not apply to model = \"shaking_table\""
                                               : conflict.text())));
  }
  for (const auto& [text, give] : features) {
    if (text.starts_with("'sides'") || text == "'subcycle' = true" || text == "a shaking table" ||
        text == "ground water" || text == "'particles_per_cell' = 1")
      continue; // these ask for another case than the heavy one
    EXPECT_THAT(errors_of(give(heavy())), IsEmpty()) << text;
  }
}

} // namespace
} // namespace tremolo::scene::testing
