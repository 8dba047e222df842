// Springs beside the dashpots: what they answer to a motion of all faces, against the integrals over the
// sides of a box; that they are slack where the soil moves with the free field; what they store; and their
// lag.

#include "mpm_domain/boundary/springs/ground_springs.hpp"

#include "tests/support/box_models.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/particle_energy.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/support_by_hand.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::add_springs;

using Springs = test_support::SupportByHand<GroundSprings>;

constexpr double modulus = 40e6 / (2.0 * 1.28); // G of elastic_box(), Pa

Spec box(double half_width, double depth, double h) {
  return test_support::elastic_box(2.0 * half_width, depth, h);
}

/// R = D along the base and b along the sides: to a centre so far away that it does not change along them.
void add_springs_of_fixed_distance(Spec& spec, double across, double along, double half_width, double depth) {
  constexpr double far = 1e9; // m
  for (const Side side : {Side::left, Side::right, Side::base}) {
    const double distance = side == Side::base ? depth : half_width;
    const Vector centre = side == Side::base ? Vector{0.0, far} : Vector{far, 0.0};
    spec.springs.push_back({side, across * far / distance, along * far / distance, centre});
  }
}

/// Force of the springs (N/m), and its moment about a point (N), after all faces have moved.
struct Answer {
  Vector force;
  double moment = 0.0;
};

Answer answer(const Spec& spec, Vector pole, const std::function<Vector(Vector)>& moved) {
  Springs springs(spec);
  const auto faces = springs.faces();
  std::vector<eq6::FreeField> at_rest(faces.size());
  std::vector<Vector> v;
  for (const BoundaryFace& face : faces)
    v.push_back(moved(face.position)); // in one second
  springs.move(0.0, v, at_rest);
  springs.move(1.0, v, at_rest);
  Answer answer;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto [x, y] = springs->at(f)->traction();
    const double length = faces[f].length;
    answer.force.x += length * x;
    answer.force.y += length * y;
    answer.moment += length * ((faces[f].position.x - pole.x) * y - (faces[f].position.y - pole.y) * x);
  }
  return answer;
}

/// Stiffnesses over G of springs on a box against vertical and horizontal motion and rotation about its
/// middle.
struct Stiffnesses {
  double vertical, horizontal, rotation;
};

Stiffnesses stiffnesses(const Spec& spec) {
  const Vector middle{0.5 * (spec.box.x_min + spec.box.x_max), 0.5 * (spec.box.y_min + spec.box.y_max)};
  return {-answer(
               spec, middle,
               [](Vector) {
                 return Vector{0.0, 1.0};
               }).force.y /
              modulus,
          -answer(
               spec, middle,
               [](Vector) {
                 return Vector{1.0, 0.0};
               }).force.x /
              modulus,
          -answer(
               spec, middle,
               [&](Vector at) {
                 return Vector{-(at.y - middle.y), at.x - middle.x};
               }).moment /
              modulus};
}

// K_v = 2b a_n G/D + 2D a_t G/b, K_h = 2b a_t G/D + 2D a_n G/b,
// K_rot = (G/D) (a_n (2b)^3/12 + a_t 2b D^2/4) + (2G/b) (a_n D^3/12 + a_t D b^2).
TEST(GroundSprings, OfFixedDistanceAnswerARigidMotionLikeTheIntegralsOverTheSides) {
  constexpr double depth = 20.0;
  for (const auto& [half_width, expected] :
       {std::pair{20.0, Stiffnesses{3.0, 3.0, 833.3333}}, std::pair{40.0, Stiffnesses{4.5, 3.0, 3166.667}}}) {
    Spec spec = box(half_width, depth, 1.0);
    add_springs_of_fixed_distance(spec, 1.0, 0.5, half_width, depth);
    const Stiffnesses found = stiffnesses(spec);
    EXPECT_NEAR(found.vertical, expected.vertical, 1e-3 * expected.vertical);
    EXPECT_NEAR(found.horizontal, expected.horizontal, 1e-3 * expected.horizontal);
    EXPECT_NEAR(found.rotation, expected.rotation, 1e-3 * expected.rotation);
  }
}

// K_v = 2G (a_n asinh(b/D) + a_t asinh(D/b)) with R from the middle of the surface.
TEST(GroundSprings, AroundTheMiddleOfTheSurfaceAnswerLikeTheIntegralsOverTheSides) {
  for (const auto& [half_width, expected] : {std::pair{20.0, 5.288}, std::pair{40.0, 6.737}}) {
    Spec spec = box(half_width, 20.0, 2.0); // 20 faces a side
    add_springs(spec, 2.0, 1.0, {half_width, 0.0});
    EXPECT_NEAR(stiffnesses(spec).vertical, expected, 0.01 * expected);
  }
}

TEST(GroundSprings, GrowNoStifferWithinTwoCells) {
  Spec spec = box(4.0, 4.0, 1.0);
  add_springs(spec, 1.0, 0.5, {0.0, -2.0}); // on the left side
  Springs springs(spec);
  double stiffest = 0.0;
  for (std::size_t f = 0; f < springs.faces().size(); ++f)
    stiffest = std::max(stiffest, springs->at(f)->stiffness.x);
  EXPECT_NEAR(stiffest, modulus / 2.0, 1e-9 * modulus);
}

// Exactly zero, although the ground is displaced by a metre and more.
TEST(GroundSprings, AreSlackWhereSoilMovesWithTheFreeField) {
  Spec spec = box(4.0, 4.0, 1.0);
  add_springs(spec, 1.0, 0.5, {4.0, 0.0});
  Springs springs(spec);
  const std::size_t count = springs.faces().size();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> velocity(-1.0, 1.5);
  std::vector<eq6::FreeField> field(count);
  std::vector<eq6::FreeField> before(count);
  std::vector<Vector> v(count);
  Vector displaced;
  for (int step = 0; step < 1000; ++step) {
    for (std::size_t f = 0; f < count; ++f) {
      field[f].velocity = {velocity(random), velocity(random)};
      v[f] = {0.5 * (before[f].velocity.x + field[f].velocity.x),
              0.5 * (before[f].velocity.y + field[f].velocity.y)};
    }
    springs.move(0.01 * step, v, field);
    displaced.x += 0.01 * v.front().x;
    before = field;
  }
  EXPECT_GT(displaced.x, 1.0);
  for (std::size_t f = 0; f < count; ++f) {
    EXPECT_EQ(springs->at(f)->traction().x, 0.0);
    EXPECT_EQ(springs->at(f)->traction().y, 0.0);
  }
}

// With tau = rho c_s/k_t a spring along the base takes 1 - exp(-t/tau) of a displacement that stays.
TEST(GroundSprings, BehindALagFollowADisplacementThatStays) {
  Spec spec = box(20.0, 20.0, 1.0);
  spec.springs.push_back({Side::base, 1.0, 0.5, {20.0, 0.0}, true});
  Springs springs(spec);
  const auto faces = springs.faces();
  const std::size_t face = faces.size() - 1;
  const double k = springs->at(face)->stiffness.x;
  const double tau = faces[face].ground.impedance_s / k;
  const double dt = 1e-3 * tau;
  std::vector<eq6::FreeField> at_rest(faces.size());
  std::vector<Vector> v(faces.size());
  springs.move(0.0, v, at_rest);
  v[face].x = 0.01 / dt; // within one step
  springs.move(dt, v, at_rest);
  EXPECT_EQ(springs->at(face)->traction().x, 0.0);
  v[face].x = 0.0;
  for (int step = 2; step <= 1001; ++step)
    springs.move(step * dt, v, at_rest);
  EXPECT_NEAR(springs->at(face)->moved.x, 0.01, 1e-12);
  EXPECT_NEAR(springs->at(face)->traction().x, -k * 0.01 * (1.0 - std::exp(-1.0)), 1e-3 * k * 0.01);
}

// A base whose dashpots see the incident wave alone has springs on another field.
TEST(GroundSprings, MoveAgainstAFieldOfTheirOwn) {
  Spec spec = box(4.0, 4.0, 1.0);
  spec.springs.push_back({Side::base, 1.0, 0.5, {4.0, 0.0}, false, true});
  Domain domain(spec);
  const std::size_t count = domain.boundary.faces().size();
  std::size_t given = 0;
  Stepper stepper(domain, 0.0, [&](long, double, auto, std::span<eq6::FreeField> field) {
    given = field.size();
    std::ranges::fill(field, eq6::FreeField{});
    for (eq6::FreeField& own : field.subspan(count))
      own.velocity.x = 0.1;
  });
  for (int step = 0; step < 3; ++step)
    stepper.step();
  const GroundSprings* const springs = domain.boundary.supports().find<GroundSprings>();
  ASSERT_NE(springs, nullptr);
  EXPECT_EQ(given, count + 16U);
  EXPECT_LT(springs->at(count - 1)->moved.x, 0.0);
  EXPECT_EQ(domain.boundary.free_field().size(), count);
}

/// What the ledger books while a box that is set moving comes to rest, J/m.
struct Books {
  double residual = 0.0; ///< the largest
  double stored = 0.0;   ///< the most that springs have stored
  double missed = 0.0;   ///< the largest difference of `springs` to what they store
};

Books books_of(const Spec& spec) {
  Domain domain(spec);
  for (Particles& set : domain.sets)
    set.vy.assign(set.size(), -0.1);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  Books books;
  while (stepper.time() < 0.5) {
    stepper.step();
    const double stored = test_support::energy_of_springs(domain);
    books.stored = std::max(books.stored, stored);
    books.missed = std::max(books.missed, std::abs(domain.energy.springs - stored));
    books.residual = std::max(books.residual, std::abs(domain.energy.residual()));
  }
  return books;
}

// sum L (k_n d_n^2 + k_t d_t^2)/2, and the residual is that of dashpots alone.
TEST(GroundSprings, StoreWhatTheLedgerBooks) {
  Spec spec = box(10.0, 10.0, 1.0);
  const Books dashpots = books_of(spec);
  add_springs(spec, 1.0, 0.5, {10.0, 0.0});
  const Books springs = books_of(spec);
  EXPECT_GT(springs.stored, 30.0); // of 1700 J/m
  EXPECT_LT(springs.missed, 1e-9 * springs.stored);
  EXPECT_LT(springs.residual, 1.02 * dashpots.residual);
}

} // namespace
} // namespace tremolo::mpm_domain
