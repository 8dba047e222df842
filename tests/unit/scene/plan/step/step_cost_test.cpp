#include "scene/plan/step/step_cost.hpp"

#include "materials/cost/update_cost.hpp"
#include "tests/unit/scene/case_text.hpp"

#include <gtest/gtest.h>

namespace tremolo::scene::testing {
namespace {

// A law counts by the share of the ground that it is the soil of.
TEST(StepCost, OfALawIsThatOfItsShareOfTheGround) {
  Case scene = parse_case(std::string(flat_case));
  const double whole = materials::update_cost_ns(scene.soils.front().law);
  EXPECT_DOUBLE_EQ(cost::law_ns(scene, materials::Response::elastic), whole);
  EXPECT_EQ(cost::law_ns(scene, materials::Response::plastic), 0.0);

  scene.soils.push_back(scene.soils.front());
  const materials::Law yielding = materials::MohrCoulomb{};
  scene.soils.back().law = yielding;
  scene.regions.push_back(scene.regions.front());
  scene.regions.back().soil = 1;
  EXPECT_DOUBLE_EQ(cost::law_ns(scene, materials::Response::elastic), 0.5 * whole);
  EXPECT_DOUBLE_EQ(cost::law_ns(scene, materials::Response::plastic),
                   0.5 * materials::update_cost_ns(yielding));
}

// A box of half the cells has twice the faces.
TEST(StepCost, OfTheBoundaryGoesWithItsFaces) {
  Case scene = parse_case(std::string(flat_case));
  const double coarse = cost::boundary_ns(scene);
  scene.mesh.size /= 2.0;
  EXPECT_NEAR(cost::boundary_ns(scene) / coarse, 2.0, 0.05);
}

} // namespace
} // namespace tremolo::scene::testing
