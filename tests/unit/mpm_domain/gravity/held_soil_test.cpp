// Soil that may fail between two verticals alone: every particle keeps its place, its soil's name and its
// stiffness, and those outside have an elastic law.

#include "mpm_domain/gravity/held_soil.hpp"

#include "mpm_domain/head/seepage_of_ground.hpp"
#include "mpm_domain/particles/fill/fill.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <variant>

namespace tremolo::mpm_domain {
namespace {

materials::MohrCoulomb soil_of(double young) {
  return {.elastic = {1800.0, young, 0.3}, .cohesion_peak = 10e3, .cohesion_residual = 10e3};
}

/// A layer of two slices, and over it a lens that is no convex polygon: two teeth that stand on a bar.
Spec layered() {
  Spec spec;
  spec.box = {0.0, 0.0, 12.0, 6.0};
  spec.cell_size = 1.0;
  spec.soils = {{"layer", soil_of(10e6)}, {"layer", soil_of(20e6)}, {"lens", soil_of(30e6)}};
  spec.regions = {
      {0, {{0.0, 0.0}, {12.0, 0.0}, {12.0, 6.0}, {0.0, 6.0}}, {3.0}},
      {2, {{1.0, 1.0}, {9.0, 1.0}, {9.0, 5.0}, {7.0, 5.0}, {7.0, 2.0}, {3.0, 2.0}, {3.0, 5.0}, {1.0, 5.0}}}};
  return spec;
}

/// What stands at a point: name of the soil, stiffness, and whether it is elastic.
using Found = std::map<std::pair<double, double>, std::tuple<std::string, double, bool>>;
Found at_places(const Spec& spec) {
  Found found;
  for (const Particles& set : fill(spec, head_of(spec)))
    for (std::size_t k = 0; k < set.size(); ++k)
      found[{set.x[k], set.y[k]}] = {set.soil, materials::elasticity(set.law).young,
                                     std::holds_alternative<materials::LinearElastic>(set.law)};
  return found;
}

TEST(HeldSoil, IsElasticBesideTheVerticalsAndTheSameOtherwise) {
  const Found given = at_places(layered());
  for (const auto& [x_min, x_max] :
       {std::pair{2.0, 8.0}, {4.0, 6.0}, {-5.0, 8.0}, {-5.0, 20.0}, {2.5, 3.5}}) {
    const Found held = at_places(held_beside(layered(), x_min, x_max));
    ASSERT_EQ(held.size(), given.size());
    for (const auto& [position, soil] : given) {
      const auto& [name, young, elastic] = held.at(position);
      EXPECT_EQ(name, std::get<0>(soil)) << position.first << ", " << position.second;
      EXPECT_EQ(young, std::get<1>(soil)) << position.first << ", " << position.second;
      EXPECT_EQ(elastic, position.first < x_min || position.first > x_max)
          << position.first << ", " << position.second;
    }
  }
}

TEST(HeldSoil, HasTheFrictionOfItsSoilAgainstStructures) {
  Spec spec = layered();
  spec.structures = {{.name = "wall", .friction = {0.3, 0.3, 0.5}, .adhesion = {0.0, 0.0, 2e3}}};
  const Spec held = held_beside(spec, 2.0, 8.0);
  ASSERT_EQ(held.structures.front().friction.size(), held.soils.size());
  for (std::size_t s = 0; s < held.soils.size(); ++s) {
    const bool lens = held.soils[s].name == "lens";
    EXPECT_EQ(held.structures.front().friction[s], lens ? 0.5 : 0.3);
    EXPECT_EQ(held.structures.front().adhesion[s], lens ? 2e3 : 0.0);
  }
}

TEST(HeldSoil, DistancesAreThoseToParticles) {
  const Spec spec = layered(); // particles of half a metre
  const Ground ground(spec);
  EXPECT_NEAR(distance_to_soil(ground, {4.25, 2.25}), 0.0, 1e-12);
  EXPECT_NEAR(distance_to_soil(ground, {4.25, 9.75}), 4.0, 1e-12);
}

} // namespace
} // namespace tremolo::mpm_domain
