// Particles, lattice and surface of elastic bodies against closed forms.

#include "mpm_domain/contact/elastic_body.hpp"
#include "mpm_domain/domain.hpp"
#include "mpm_domain/head/seepage_of_ground.hpp"
#include "mpm_domain/particles/fill/fill_bodies.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace tremolo::mpm_domain {
namespace {

using test_support::circle;
using test_support::flat_ground;
using test_support::rectangle;
using test_support::structure;
using test_support::turned;

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

Spec with_body(std::vector<Vector> outline, double density) {
  Spec spec = flat_ground(12.0, 4.0, 0.5, {1900.0, 1e8, 0.3});
  spec.structures = {structure(std::move(outline), density, 0.5)};
  spec.structures.front().stiffness = Stiffness{3e8, 0.2};
  return spec;
}

TEST(FillBodies, HaveAreaMassAndStiffnessOfTheStructure) {
  Spec spec = with_body(circle({0.3, 2.1}, 1.7), 1234.0);
  spec.structures.front().hole = turned(rectangle(-0.3, 1.5, 0.9, 2.4), {0.0, 2.0}, 0.3);
  const std::vector<Particles> sets = fill_bodies(spec, head_of(spec), 0);
  ASSERT_EQ(sets.size(), 1U);
  const Particles& set = sets.front();
  const double area = std::numbers::pi * 1.7 * 1.7 - 1.2 * 0.9;
  EXPECT_NEAR(sum(set.mass), 1234.0 * area, 1e-9 * sum(set.mass));
  EXPECT_NEAR(sum(set.volume), area, 2e-3 * area);
  EXPECT_EQ(set.body, 0U);
  EXPECT_EQ(materials::elasticity(set.law).young, 3e8);
  EXPECT_EQ(materials::elasticity(set.law).poisson, 0.2);
  EXPECT_EQ(set.weight_share, 1.0);
}

TEST(FillBodies, WeighLessUnderWater) {
  Spec spec = with_body(rectangle(-1.0, -2.0, 1.0, 2.0), 2500.0);
  spec.soils.front().pores =
      materials::PoreSpace{.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-4};
  spec.water = GroundWater{.level = 0.0, .fluid = {.density = 1000.0}};
  const std::vector<Particles> sets = fill_bodies(spec, head_of(spec), 0);
  ASSERT_EQ(sets.size(), 2U);
  double weight = 0.0; // over g
  for (const Particles& set : sets) {
    EXPECT_NEAR(sum(set.volume), 4.0, 1e-12);
    weight += set.weight_share * sum(set.mass);
  }
  EXPECT_NEAR(weight, 8.0 * 2500.0 - 4.0 * 1000.0, 1e-9);
}

TEST(FillBodies, AreRefusedWithoutStiffness) {
  Spec spec = with_body(rectangle(-1.0, 0.0, 1.0, 2.0), 2500.0);
  spec.structures.front().stiffness = Stiffness{0.0, 0.2};
  EXPECT_THROW(fill_bodies(spec, head_of(spec), 0), std::invalid_argument);
  spec.structures.front().stiffness = Stiffness{1e9, 0.5};
  EXPECT_THROW(fill_bodies(spec, head_of(spec), 0), std::invalid_argument);
}

TEST(BodyLattice, LiesOnNodesOfTheFinestCellsAndFollowsTheBody) {
  Spec spec = with_body(rectangle(-1.0, -0.6, 1.0, 3.0), 2000.0);
  spec.refine = {{{-4.0, -2.0, 4.0, 0.0}, 1}};
  Domain domain(spec);
  const auto expect_in_place = [&] {
    ASSERT_EQ(domain.bodies.size(), 1U);
    const BodyLattice& body = domain.bodies.front();
    const Lattice& soil = domain.finest_lattice();
    EXPECT_EQ(body.lattice.h, soil.h);
    EXPECT_DOUBLE_EQ(body.lattice.x0, soil.x0 + body.column * soil.h);
    EXPECT_DOUBLE_EQ(body.lattice.y0, soil.y0 + body.row * soil.h);
    EXPECT_EQ(body.lattice.first, soil.first + soil.count());
    EXPECT_EQ(domain.grid.size(), body.lattice.first + body.lattice.count());
    EXPECT_EQ(body.node_at(body.column + 2, body.row + 1), body.lattice.index(2, 1));
    EXPECT_FALSE(body.node_at(body.column - 1, body.row));
    EXPECT_FALSE(body.node_at(body.column, body.row + body.lattice.ny));
    for (const Particles& set : domain.body_sets())
      for (std::size_t k = 0; k < set.size(); ++k) {
        EXPECT_GT(set.x[k], body.lattice.x0 + 2.0 * soil.h);
        EXPECT_LT(set.y[k], body.lattice.y0 + (body.lattice.ny - 3) * soil.h);
      }
  };
  expect_in_place();
  const int before = domain.bodies.front().row;
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; set.body && k < set.size(); ++k)
      set.y[k] += 7.0;
  sort_particles(domain);
  expect_in_place();
  EXPECT_EQ(domain.bodies.front().row, before + 28); // cells of 0.25 m
}

TEST(ElasticBody, FollowsATurn) {
  const Spec spec = with_body(turned(rectangle(-1.1, 0.2, 0.9, 3.1), {0.0, 1.0}, 0.2), 2000.0);
  Domain domain(spec);
  constexpr double tilt = 2.0, spin = 0.7;
  const Vector pivot{1.0, 2.0};
  const Vector moved{0.3, -0.2};
  const auto at = [&](const Vector& p) {
    const Vector d{p.x - pivot.x, p.y - pivot.y};
    return Vector{pivot.x + moved.x + std::cos(tilt) * d.x - std::sin(tilt) * d.y,
                  pivot.y + moved.y + std::sin(tilt) * d.x + std::cos(tilt) * d.y};
  };
  ElasticBody body(spec.structures.front(), 0, domain.body_sets(), 0.5);
  const std::vector<Vector> outline = body.surface().points();
  EXPECT_GT(outline.size(), 18U); // around 9.8 m
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; set.body && k < set.size(); ++k) {
      const Vector now = at({set.x[k], set.y[k]});
      set.x[k] = now.x;
      set.y[k] = now.y;
      set.vx[k] = 0.1 - spin * now.y;
      set.vy[k] = spin * now.x;
    }
  RigidBody whole(spec.structures.front());
  const Vector centre = at(whole.centre());
  body.follow(domain.body_sets(), whole);
  EXPECT_NEAR(whole.tilt(), tilt, 1e-12);
  EXPECT_NEAR(whole.motion().spin, spin, 1e-12);
  EXPECT_NEAR(whole.centre().x, centre.x, 2e-3); // particles at centroids of cut squares
  EXPECT_NEAR(whole.centre().y, centre.y, 2e-3);
  for (std::size_t n = 0; n < outline.size(); ++n) {
    EXPECT_NEAR(body.surface().points()[n].x, at(outline[n]).x, 1e-12);
    EXPECT_NEAR(body.surface().points()[n].y, at(outline[n]).y, 1e-12);
  }
}

/// A point on an edge that bends is no corner.
TEST(BodySurface, KnowsItsCorners) {
  const BodySurface surface({{0.0, 0.0}, {1.0, -0.01}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}});
  const auto below = surface.nearest({1.0, -0.5});
  EXPECT_FALSE(below.corner);
  EXPECT_NEAR(below.distance, 0.49, 1e-12);
  EXPECT_NEAR(below.normal.y, -1.0, 1e-12);
  EXPECT_TRUE(surface.nearest({2.5, -0.5}).corner);
  EXPECT_LT(surface.nearest({1.0, 0.1}).distance, 0.0);
}

/// Corners that stick out are toes; a point beyond one stands on it, others next to themselves.
TEST(BodySurface, KnowsItsToes) {
  const BodySurface angle({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}});
  EXPECT_EQ(angle.toes().size(), 5U);
  EXPECT_TRUE(BodySurface(test_support::circle({0.0, 0.0}, 1.0, 48)).toes().empty());
  const auto below = angle.foot({0.3, -0.1}, {0.0, -1.0});
  ASSERT_TRUE(below);
  EXPECT_FALSE(below->toe);
  EXPECT_NEAR(below->position.x, 0.3, 1e-15);
  EXPECT_NEAR(below->position.y, 0.0, 1e-15);
  const auto beside = angle.foot({2.2, 0.1}, {0.0, -1.0}); // next to it is the edge on the right
  ASSERT_TRUE(beside);
  EXPECT_TRUE(beside->toe);
  EXPECT_NEAR(beside->position.x, 2.0, 1e-15);
  EXPECT_NEAR(beside->position.y, 0.0, 1e-15);
  const auto inner = angle.foot({0.9, 1.1}, {0.0, 1.0});
  ASSERT_TRUE(inner);
  EXPECT_NEAR(inner->position.x, 1.0, 1e-15); // of the step; its end inside the angle is no toe
  EXPECT_FALSE(inner->toe);
}

} // namespace
} // namespace tremolo::mpm_domain
