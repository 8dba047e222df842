// Which supports a spec puts behind its faces, what they make of the faces, and what each exerts when it is
// moved by hand.

#include "mpm_domain/boundary/layer/matched_layer.hpp"
#include "mpm_domain/boundary/tied/periodic_springs.hpp"
#include "tests/support/box_models.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/saved_state.hpp"
#include "tests/support/support_by_hand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using Names = std::vector<std::string>;

Spec box() {
  Spec spec = test_support::elastic_box(6.0, 4.0, 1.0);
  spec.layer_cells = 3;
  return spec;
}

Spec layered_box() {
  Spec spec = box();
  test_support::add_layers(spec);
  return spec;
}

Spec sharp_box_with_springs() {
  Spec spec = box();
  spec.scheme.dispersion = Dispersion::reduced;
  test_support::add_springs(spec, 1.0, 0.5, {3.0, 0.0});
  return spec;
}

Names names_of(const Domain& domain) {
  Names names;
  for (const auto& support : domain.boundary.supports().all())
    names.push_back(support->name());
  return names;
}

std::ptrdiff_t faces_with_dashpots(const Domain& domain) {
  return std::ranges::count_if(domain.boundary.faces(),
                               [](const BoundaryFace& face) { return face.behind.has_dashpots; });
}

TEST(Supports, AreThoseThatTheSpecWants) {
  EXPECT_EQ(names_of(Domain(box())), Names{});
  EXPECT_EQ(names_of(Domain(layered_box())), Names{"matched layers"});
  EXPECT_EQ(names_of(Domain(sharp_box_with_springs())), (Names{"ground springs", "closing elements"}));
  Spec tied = box();
  tied.sides = Sides::periodic_springs;
  EXPECT_EQ(names_of(Domain(tied)), Names{"springs between the sides"});
  Spec shaken = box();
  test_support::put_into_container(shaken);
  EXPECT_EQ(names_of(Domain(shaken)), Names{"rigid base"});
}

TEST(Supports, StandInThePlaceOfDashpotsOrBesideThem) {
  EXPECT_EQ(faces_with_dashpots(Domain(box())), 28);
  EXPECT_EQ(faces_with_dashpots(Domain(layered_box())), 0);
  Spec springs = box();
  test_support::add_springs(springs, 1.0, 0.5, {3.0, 0.0});
  EXPECT_EQ(faces_with_dashpots(Domain(springs)), 28);
  Spec base = box();
  base.matched_sides = {Side::base};
  EXPECT_EQ(faces_with_dashpots(Domain(base)), 16);
}

/// The faces of another domain at rest have other impedances, and supports are made anew of them.
TEST(Supports, AreMadeAnewWhereFacesComeToAnotherRest) {
  Domain domain(sharp_box_with_springs());
  for (BoundaryFace& face : domain.boundary.faces())
    face.ground.impedance_p *= 2.0;
  const double mass = domain.boundary.faces().front().behind.moving_mass.x;
  EXPECT_GT(mass, 0.0);
  test_support::SavedState rest;
  domain.boundary.save_rest(rest);
  Domain again(sharp_box_with_springs());
  again.boundary.restore_rest(again, rest);
  EXPECT_EQ(names_of(again), names_of(domain));
  EXPECT_NEAR(again.boundary.faces().front().behind.moving_mass.x, 2.0 * mass, 1e-12 * mass);
}

TEST(Supports, AreRefusedTheStateOfOthers) {
  Domain domain(layered_box());
  test_support::SavedState saved;
  domain.boundary.save(saved);
  Spec wider = layered_box();
  wider.layer_cells = 4;
  EXPECT_THROW(Domain(wider).boundary.restore(saved), std::runtime_error);
}

/// Soil that moves away from a layer meets -rho c_p v, as of a dashpot; where the free field moves with it,
/// nothing.
TEST(MatchedLayers, AnswerABlowLikeDashpots) {
  constexpr double v = 0.01;
  constexpr int steps = 2000;
  for (const double of_field : {0.0, v}) {
    test_support::SupportByHand<MatchedLayers> layers(layered_box());
    const std::size_t count = layers.faces().size();
    const BoundaryFace& left = layers.faces().front();
    const double dt = 2e-3 * left.length * left.density / left.ground.impedance_p;
    std::vector<eq6::FreeField> field(count, {{of_field, 0.0}, {}});
    double impulse = 0.0;
    for (int step = 0; step < steps; ++step)
      impulse += dt * layers.move(step * dt, std::vector<Vector>(count, {v, 0.0}), field).front().own.x;
    const double of_dashpot = -left.ground.impedance_p * v * steps * dt;
    if (of_field == v)
      EXPECT_EQ(impulse, 0.0);
    else
      EXPECT_NEAR(impulse, of_dashpot, 0.25 * std::abs(of_dashpot)); // less what its mass would take
  }
}

TEST(PeriodicSprings, PullOppositeFacesTogetherAndShowEachTheOther) {
  Spec spec = box();
  spec.sides = Sides::periodic_springs;
  test_support::SupportByHand<PeriodicSprings> ties(spec);
  const auto faces = ties.faces();
  const auto pairs = static_cast<std::size_t>(std::ranges::count(faces, Side::left, &BoundaryFace::side));
  EXPECT_TRUE(faces[2 * pairs - 1].behind.is_tied);
  EXPECT_FALSE(faces[2 * pairs].behind.is_tied) << "the base";
  Particles& set = ties.domain().sets[faces.front().set];
  set.x[set.index_of[faces.front().id]] += 1e-3;
  std::vector<eq6::FreeField> field(faces.size());
  std::vector<Vector> v(faces.size());
  v[pairs] = {0.0, 2.0};
  const auto loads = ties.move(0.0, v, field);
  EXPECT_LT(loads[0].driven.x, 0.0);
  EXPECT_EQ(loads[pairs].driven.x, -loads[0].driven.x);
  EXPECT_EQ(loads[1].driven.x, 0.0);
  EXPECT_EQ(field[0].velocity.y, 2.0);
  EXPECT_EQ(field[pairs].velocity.y, 0.0);
}

/// Of a box that moves as a whole: every face sees its velocity, now and in the mean.
TEST(FaceMotion, OfABoxThatMovesAsAWholeIsItsVelocity) {
  Spec spec = box();
  spec.refine = {{{0.0, -2.0, 3.0, 0.0}, 1}};
  spec.scheme.subcycle = true;
  Domain domain(spec);
  for (Particles& set : domain.sets)
    set.vx.assign(set.size(), 1.5);
  std::vector<Vector> seen;
  Stepper stepper(domain, 0.0, [&seen](long, double, std::span<const Vector> v, auto field) {
    seen.assign(v.begin(), v.end());
    std::ranges::fill(field, eq6::FreeField{{1.5, 0.0}, {}});
  });
  for (int step = 0; step < 5; ++step)
    stepper.step();
  ASSERT_EQ(seen.size(), domain.boundary.faces().size());
  for (std::size_t f = 0; f < seen.size(); ++f) {
    EXPECT_NEAR(seen[f].x, 1.5, 1e-9);
    EXPECT_NEAR(domain.boundary.traction(f).x, 0.0, 1e-3) << "Pa, of impedances of 3e5 Pa s/m";
  }
}

} // namespace
} // namespace tremolo::mpm_domain
