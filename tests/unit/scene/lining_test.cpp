// [[lining]]: what its keys give, and what the plan makes of it.

#include "lining_case.hpp"

#include "mesh/polygon_measures.hpp"
#include "scene/plan/lining/beam_outline.hpp"
#include "scene/plan/plan.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::string_view circle_text = "circle = { centre = [10.0, -5.0], radius = 2.1 }";
constexpr std::string_view box_text = "polygon = [[7.5, -3.0], [12.5, -3.0], [12.5, -7.0], [7.5, -7.0]]";

TEST(Lining, IsRead) {
  const Case scene = parse_case(ring_with("friction = 0.5", "friction = 0.5\nadhesion = 2e3\n"
                                                            "hinges = [[10.0, -2.9], [12.0, -5.0]]"));
  ASSERT_EQ(scene.linings.size(), 1U);
  const Lining& ring = scene.linings[0];
  EXPECT_EQ(ring.name, "ring");
  EXPECT_EQ(ring.outline.key, "circle");
  EXPECT_NEAR(area(ring.outline.corners), std::numbers::pi * 4.41, 1e-12);
  EXPECT_EQ(ring.thickness, 0.2);
  EXPECT_DOUBLE_EQ(ring.section.bending, 30e9 / 0.96 * 0.008 / 12.0);
  EXPECT_DOUBLE_EQ(ring.section.mass, 500.0);
  ASSERT_EQ(ring.hinges.size(), 2U);
  EXPECT_EQ(ring.hinges[1].x, 12.0);
  ASSERT_EQ(ring.against.size(), 1U);
  EXPECT_EQ(ring.against[0].friction, 0.5);
  EXPECT_EQ(ring.against[0].adhesion, 2e3);
  EXPECT_THAT(parse_case(heavy()).linings, IsEmpty());
}

TEST(Lining, MayHaveAnySection) {
  const mpm_domain::BeamSection section =
      parse_case(ring_with("young = 30e9\npoisson = 0.2\ndensity = 2500.0",
                           "axial_stiffness = 6e9\nbending_stiffness = 2e7\nmass = 480.0"))
          .linings.at(0)
          .section;
  EXPECT_EQ(section.axial, 6e9);
  EXPECT_EQ(section.bending, 2e7);
  EXPECT_EQ(section.mass, 480.0);
  EXPECT_DOUBLE_EQ(section.rotary, 1.6);
  EXPECT_TRUE(std::isinf(section.shear));
}

TEST(Lining, WrongKeysAreRefusedWhereTheyStand) {
  const auto ring = [](std::string_view old, std::string_view by) { return errors_of(ring_with(old, by)); };
  EXPECT_THAT(ring("thickness = 0.2", "thicknes = 0.2"),
              ElementsAre(HasSubstr("case.toml:33:1: [[lining]] missing 'thickness', number m"),
                          "case.toml:36:1: [[lining]] unknown key 'thicknes', did you mean 'thickness'?"));
  EXPECT_THAT(ring(circle_text, ""),
              ElementsAre("case.toml:33:1: [[lining]] missing 'polygon' or 'circle': the outer face of the "
                          "lining"));
  EXPECT_THAT(ring("poisson = 0.2\nd", "d"),
              ElementsAre("case.toml:33:1: [[lining]] missing 'poisson': 'young' needs it"));
  EXPECT_THAT(
      ring("young = 30e9\npoisson = 0.2\ndensity = 2500.0\n", ""),
      ElementsAre("case.toml:33:1: [[lining]] missing 'young', 'poisson' and 'density' of a plate, or "
                  "'axial_stiffness', 'bending_stiffness' and 'mass'"));
  EXPECT_THAT(ring("young = 30e9", "young = 30e9\nmass = 480.0"),
              ElementsAre("case.toml:38:8: [[lining]] 'young' and 'mass' exclude each other: remove one"));
  EXPECT_THAT(
      ring("friction = 0.5", "friction = 0.5\nhinges = []"),
      ElementsAre("case.toml:41:10: [[lining]] 'hinges' must be an array of at least 1 point [[x, y], "
                  "...], found 0 entries"));
  EXPECT_THAT(ring("friction = 0.5", "friction = 0.5\nagainst = [{ soil = \"sad\", friction = 0.3 }]"),
              ElementsAre(HasSubstr("[[lining.against]] soil 'sad' is not defined, did you mean 'sand'?")));
}

/// Lengths of a closed polygon's edges.
std::vector<double> edges(const Polygon& polygon) {
  std::vector<double> lengths;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point a = polygon[k];
    const Point b = polygon[(k + 1) % polygon.size()];
    lengths.push_back(std::hypot(b.x - a.x, b.y - a.y));
  }
  return lengths;
}

TEST(Lining, HasSixtyFourElementsAtLeastAndNoneLongerThanACell) {
  const Lining ring = parse_case(with_ring()).linings.at(0);
  EXPECT_EQ(beam_outline(ring, 1.0).corners.size(), 64U);
  EXPECT_EQ(beam_outline(ring, 0.11).corners.size(), 128U);
  EXPECT_LE(std::ranges::max(edges(beam_outline(ring, 0.11).corners)), 0.11);
  // A culvert of 18 m around, clockwise in the case: 18 elements in 5 m and 15 in 4 m.
  const Lining culvert = parse_case(ring_with(circle_text, box_text)).linings.at(0);
  const BeamOutline beam = beam_outline(culvert, 1.0);
  EXPECT_EQ(beam.corners.size(), 66U);
  EXPECT_GT(mesh::signed_double_area(beam.corners), 0.0);
  EXPECT_LE(std::ranges::max(edges(beam.corners)), 18.0 / 64.0);
  EXPECT_DOUBLE_EQ(area(beam.corners), 20.0);
}

TEST(Lining, HasItsHingesWhereTheyAreGiven) {
  Lining culvert = parse_case(ring_with(circle_text, box_text)).linings.at(0);
  // In the roof, near enough to a corner, and within the wall.
  culvert.hinges = {{10.1, -3.0}, {12.49, -3.02}, {7.6, -5.03}};
  const BeamOutline beam = beam_outline(culvert, 1.0);
  ASSERT_EQ(beam.hinges.size(), 3U);
  const auto is_hinge = [&](double x, double y) {
    return std::ranges::any_of(beam.hinges, [&](std::size_t k) {
      return std::hypot(beam.corners[k].x - x, beam.corners[k].y - y) < 1e-12;
    });
  };
  EXPECT_TRUE(is_hinge(10.1, -3.0));
  EXPECT_TRUE(is_hinge(12.5, -3.0));
  EXPECT_TRUE(is_hinge(7.5, -5.03));
  EXPECT_DOUBLE_EQ(area(beam.corners), 20.0);
}

TEST(Lining, IsPlanned) {
  const Case scene = parse_case(with_ring());
  const Plan planned = plan(scene);
  ASSERT_EQ(planned.linings.size(), 1U);
  const PlannedLining& ring = planned.linings[0];
  EXPECT_EQ(ring.elements, 64U);
  EXPECT_NEAR(ring.axis, 4.0 * std::numbers::pi, 0.01);
  EXPECT_NEAR(ring.mass, 500.0 * 4.0 * std::numbers::pi, 5.0);
  ASSERT_TRUE(ring.ring);
  // R = 2 m, EI = 20.83 MN m, m = 500 kg/m2: omega^2 = 7.2 EI/(m R^4).
  EXPECT_NEAR(ring.ring->period, 2.0 * std::numbers::pi / std::sqrt(7.2 * 20.8333e6 / (500.0 * 16.0)), 1e-5);
  EXPECT_NEAR(ring.ring->flexibility, 40e6 / 2.56 * 8.0 / (3.0 * 20.8333e6), 1e-3);
  EXPECT_EQ(ring.ring->soil, "sand");
  // l sqrt(m/EA) of elements 2 pi 2 m/64 long.
  EXPECT_NEAR(ring.explicit_step, 4.0 * std::numbers::pi / 64.0 * std::sqrt(500.0 / 6.25e9), 1e-7);
  const Plan flat = plan(parse_case(heavy()));
  EXPECT_LT(planned.particles, flat.particles);
  EXPECT_EQ(planned.dt, flat.dt);
  EXPECT_TRUE(std::ranges::find(planned.effects, "linings", &Effect::name)->on);
  EXPECT_THAT(explain(scene, planned),
              AllOf(HasSubstr("\nLinings\n  ring              0.2 m thick around an axis of 12.57 m"),
                    HasSubstr("ovals freely with a period of"), HasSubstr("does not set it")));
  const auto json = nlohmann::json::parse(to_json(scene, planned));
  EXPECT_EQ(json.at("linings").at(0).at("elements"), 64);
  EXPECT_FALSE(std::ranges::find(flat.effects, "linings", &Effect::name)->on);
  EXPECT_THAT(explain(parse_case(heavy()), flat), Not(HasSubstr("\nLinings\n")));
}

/// A box of 5 m x 4 m with walls of 0.2 m: 20 m2 less 4.6 m x 3.6 m of concrete.
TEST(Lining, HasTheMassOfItsWalls) {
  const PlannedLining culvert = plan(parse_case(ring_with(circle_text, box_text))).linings.at(0);
  EXPECT_NEAR(culvert.axis, 17.2, 1e-9);
  EXPECT_NEAR(culvert.mass, 2500.0 * (20.0 - 4.6 * 3.6), 1e-6);
  EXPECT_FALSE(culvert.ring);
}

/// The explicit steps of the reference ring (shared with tests/verification/mpm_domain/lining): 64 elements
/// of 0.294 m, 8.3e-5 s, and 4.8e-5 s where they do not shear.
TEST(Lining, IsPlannedWithTheStepThatExplicitElementsWouldNeed) {
  std::string text = with("radius = 2.1", "radius = 3.15", with_ring());
  text = with("thickness = 0.2", "thickness = 0.3", text);
  for (const auto& [old, by] :
       {std::pair("polygon = [[0.0, -10.0], [20.0, -10.0]", "polygon = [[0.0, -20.0], [20.0, -20.0]"),
        std::pair("box = [0.0, -10.0", "box = [0.0, -20.0"),
        std::pair("reference = [0.0, -10.0]", "reference = [0.0, -20.0]"),
        std::pair("centre = [10.0, -5.0]", "centre = [10.0, -10.0]")})
    text = with(old, by, text);
  EXPECT_NEAR(plan(parse_case(text)).linings.at(0).explicit_step, 8.3e-5, 0.05e-5);
  EXPECT_NEAR(plan(parse_case(text)).linings.at(0).ring->period, 1.0 / 14.529, 1e-4);
  text = with("young = 30e9\npoisson = 0.2\ndensity = 2500.0",
              "axial_stiffness = 9.375e9\nbending_stiffness = 7.03125e7\nmass = 750.0", text);
  EXPECT_NEAR(plan(parse_case(text)).linings.at(0).explicit_step, 4.8e-5, 0.05e-5);
}

} // namespace
} // namespace tremolo::scene::testing
