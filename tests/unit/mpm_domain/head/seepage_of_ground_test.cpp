#include "mpm_domain/head/ground_mesh.hpp"
#include "mpm_domain/head/seepage_of_ground.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

namespace tremolo::mpm_domain {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Soil soil(const char* name, double permeability) {
  Soil soil{.name = name};
  soil.pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = permeability};
  soil.law = materials::LinearElastic{{materials::saturated_density(*soil.pores, {}), 50e6, 0.3}};
  return soil;
}

/// A slope of 1:2 from y = 6 to y = 2 on a base at y = 0, with corners between nodes.
Spec slope(double cell = 1.0) {
  Spec spec;
  spec.box = {0.0, 0.0, 24.0, 7.0};
  spec.cell_size = cell;
  spec.gravity = 9.81;
  spec.water = {5.0, {}};
  spec.soils = {soil("sand", 1e-4)};
  spec.regions = {{0, {{0.0, 0.0}, {24.0, 0.0}, {24.0, 2.3}, {15.6, 2.3}, {8.2, 6.0}, {0.0, 6.0}}}};
  return spec;
}

double surface_of_slope(double x) {
  return std::clamp(6.0 - 0.5 * (x - 8.2), 2.3, 6.0);
}

TEST(GroundMesh, HasItsUpperNodesOnTheSurface) {
  const GroundMesh mesh = mesh_of(slope());
  ASSERT_FALSE(mesh.surface.empty());
  for (const std::size_t n : mesh.surface) {
    const Vector& at = mesh.problem.nodes[n];
    EXPECT_NEAR(at.y, surface_of_slope(at.x), 1e-9) << at.x;
  }
  for (const std::size_t n : mesh.left)
    EXPECT_EQ(mesh.problem.nodes[n].x, 0.0);
  for (const std::size_t n : mesh.right)
    EXPECT_EQ(mesh.problem.nodes[n].x, 24.0);
}

TEST(GroundMesh, HasTheSizeOfTheFinestCells) {
  Spec spec = slope();
  spec.refine = {{{4.0, 0.0, 8.0, 4.0}, 1}};
  EXPECT_EQ(mesh_of(spec).grid.h, 0.5);
  EXPECT_GT(mesh_of(slope(1.0 / 64.0)).grid.h, 1.0 / 64.0); // more nodes than are solved for in seconds
}

TEST(SeepageOfGround, RestsBetweenEqualLevels) {
  Spec spec = slope();
  for (const double level : {1.5, 4.0, 6.5}) {
    spec.water->seepage = {level, level};
    const SeepageOfGround seepage = seep(spec);
    EXPECT_LT(seepage.found.discharge, 1e-15);
    for (const double x : {0.3, 9.1, 12.0, 23.9})
      for (const double y : {0.2, 1.7})
        EXPECT_NEAR(seepage.head.at(x, y).head, level, 1e-9);
  }
}

// Free water in front of the slope lies on it: the head is that of the water there, and none leaves above.
TEST(SeepageOfGround, HasTheHeadOfFreeWaterOnTheGroundBelowIt) {
  Spec spec = slope(0.5);
  spec.water->seepage = {5.0, 3.5};
  const SeepageOfGround seepage = seep(spec);
  for (const double x : {15.0, 17.0, 22.0})
    EXPECT_NEAR(seepage.head.at(x, surface_of_slope(x)).head, 3.5, 0.03) << x;
  EXPECT_NEAR(seepage.head.surface(22.0, 0.0, 7.0), 3.5, 1e-6);
  EXPECT_NEAR(seepage.head.at(0.0, 1.0).head, 5.0, 1e-9);
  ASSERT_TRUE(seepage.found.exit);
  EXPECT_GT(seepage.found.exit->y, 3.4);
  EXPECT_LT(seepage.found.exit->y, 4.5);
}

TEST(SeepageOfGround, FlowsFromRightToLeftAsFromLeftToRight) {
  Spec spec = slope(0.5);
  spec.water->seepage = {5.0, 3.5};
  const SeepageOfGround one = seep(spec);
  for (Vector& corner : spec.regions[0].polygon)
    corner.x = 24.0 - corner.x;
  spec.water->seepage = {3.5, 5.0};
  const SeepageOfGround other = seep(spec);
  EXPECT_NEAR(one.found.discharge, other.found.discharge, 1e-9 * one.found.discharge);
  EXPECT_NEAR(one.head.at(7.0, 3.0).head, other.head.at(17.0, 3.0).head, 1e-6);
}

// A wall that all but cuts the ground off holds the water up, and so does a lining.
TEST(SeepageOfGround, GoesAroundStructuresAndLinings) {
  Spec spec = slope(0.5);
  spec.water->seepage = {5.0, 3.5};
  const double open = seep(spec).found.discharge;
  Structure wall;
  wall.outline = {{7.0, 1.0}, {8.0, 1.0}, {8.0, 6.0}, {7.0, 6.0}};
  spec.structures = {wall};
  const SeepageOfGround held = seep(spec);
  EXPECT_LT(held.found.discharge, 0.7 * open);
  EXPECT_GT(held.head.at(6.5, 3.0).head - held.head.at(8.5, 3.0).head, 0.5);
  spec.structures.clear();
  Lining lining;
  lining.outline = wall.outline;
  spec.linings = {lining};
  EXPECT_DOUBLE_EQ(seep(spec).found.discharge, held.found.discharge);
}

TEST(SeepageOfGround, IsRefusedWhereItCannotBe) {
  Spec spec = slope();
  spec.water->seepage = {7.5, 6.5};
  EXPECT_THAT([&] { seep(spec); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("would meet over the ground")));
  spec.water->seepage = {5.0, 3.5};
  spec.soils = {soil("rock", 0.0)};
  EXPECT_THAT([&] { seep(spec); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("soil 'rock' has no permeability")));
}

} // namespace
} // namespace tremolo::mpm_domain
