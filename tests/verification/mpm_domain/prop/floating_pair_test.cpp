// Two bodies that float without weight with a prop between them: two masses on a spring. With their masses
// m_a and m_b, mu = m_a m_b/(m_a + m_b) and a speed v at which they part,
//
//     L = L_0 + v/omega sin(omega t),      omega^2 = k/mu,
//
// and where the prop yields at N_y it dissipates mu v^2/2 - N_y^2/(2 k) in the first swing and nothing after.

#include "mpm_domain/state.hpp"
#include "tests/support/saved_state.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::quiet_ground;
using test_support::rectangle;
using test_support::structure;

constexpr double stiffness = 1e6; // k, N/m2
constexpr double mass_a = 2000.0; // kg/m
constexpr double mass_b = 1000.0;
constexpr double reduced_mass = mass_a * mass_b / (mass_a + mass_b);

Structure floating(const char* name, double x, double density, bool elastic) {
  Structure body = structure(rectangle(x - 0.5, 3.5, x + 0.5, 4.5), density, 0.5);
  body.name = name;
  if (elastic)
    body.stiffness = Stiffness{5e8, 0.2};
  return body;
}

/// Bodies of 1 m by 1 m whose middles are 4 m apart, and a prop from face to face.
Spec pair(bool elastic_a, bool elastic_b, double offset_a = 0.0, double offset_b = 0.0) {
  Spec spec = flat_ground(8.0, 1.0, 0.25, {2000.0, 2e8, 0.2});
  spec.gravity = 0.0;
  spec.structures = {floating("a", -2.0, mass_a, elastic_a), floating("b", 2.0, mass_b, elastic_b)};
  Prop prop;
  prop.name = "strut";
  prop.from = {"a", {-1.5, 4.0 + offset_a}};
  prop.to = {"b", {1.5, 4.0 + offset_b}};
  prop.stiffness = stiffness;
  spec.props = {prop};
  return spec;
}

/// Parts them along x with a speed (m/s), while all of it stands still.
void part(Domain& domain, double speed) {
  test_support::set_motion(domain, 0, {{-speed * reduced_mass / mass_a, 0.0}, 0.0});
  test_support::set_motion(domain, 1, {{speed * reduced_mass / mass_b, 0.0}, 0.0});
}

/// Largest error of L in a period, over its amplitude.
double error_of_length(double dt) {
  Spec spec = pair(false, false);
  spec.scheme.dt = dt;
  Domain domain(spec);
  constexpr double speed = 0.1;
  part(domain, speed);
  Stepper stepper(domain, 0.0, quiet_ground());
  const double omega = std::sqrt(stiffness / reduced_mass);
  double worst = 0.0;
  while (stepper.time() < 6.28 / omega) {
    stepper.step();
    const double exact = 3.0 + speed / omega * std::sin(omega * stepper.time());
    worst = std::max(worst, std::abs(domain.props.all()[0].length - exact));
  }
  return worst * omega / speed;
}

TEST(FloatingPair, SwingsAsTwoMassesOnASpringAtSecondOrder) {
  const double coarse = error_of_length(4e-4);
  const double fine = error_of_length(2e-4);
  RecordProperty("errors", std::to_string(coarse) + " and " + std::to_string(fine));
  EXPECT_LT(fine, 1e-4);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
}

TEST(FloatingPair, LosesInItsFirstSwingWhatIsOverTheYieldForce) {
  Spec spec = pair(false, false);
  spec.scheme.dt = 1e-4;
  spec.props.front().yield = 1.5e3;
  Domain domain(spec);
  constexpr double speed = 0.1;
  part(domain, speed);
  Stepper stepper(domain, 0.0, quiet_ground());
  while (stepper.time() < 0.5)
    stepper.step();
  const double lost = 0.5 * reduced_mass * speed * speed - 0.5 * 1.5e3 * 1.5e3 / stiffness;
  EXPECT_NEAR(domain.energy.plastic, lost, 2e-3 * lost);
  const double at_start =
      0.5 * reduced_mass * speed * speed; // which the ledger of rigid bodies begins without
  EXPECT_NEAR(domain.energy.residual(), at_start, 1e-3 * at_start);
}

/// Momentum (kg/s) and angular momentum (kg m/s) of both bodies.
struct Momentum {
  Vector linear;
  double angular = 0.0;
};

Momentum momentum_of(const Domain& domain) {
  Momentum all;
  for (std::size_t b = 0; b < domain.contact.bodies().size(); ++b)
    if (const RigidBody& body = domain.contact.bodies()[b]; !domain.contact.is_elastic(b)) {
      all.linear = all.linear + body.mass() * body.motion().velocity;
      all.angular +=
          body.mass() * cross(body.centre(), body.motion().velocity) + body.inertia() * body.motion().spin;
    }
  for (const Particles& set : domain.body_sets())
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Vector v{set.vx[k], set.vy[k]};
      all.linear = all.linear + set.mass[k] * v;
      all.angular += set.mass[k] * (cross({set.x[k], set.y[k]}, v) + set.byx[k] - set.bxy[k]);
    }
  return all;
}

class AnyPair : public testing::TestWithParam<std::pair<bool, bool>> {};

TEST_P(AnyPair, KeepsItsMomentumAndAngularMomentum) {
  // The prop slants and passes by both middles; the bodies turn and go apart.
  Spec spec = pair(GetParam().first, GetParam().second, 0.4, -0.3);
  spec.props.front().prestress = 2e3;
  Domain domain(spec);
  test_support::set_motion(domain, 0, {{-0.2, 0.3}, 0.5});
  test_support::set_motion(domain, 1, {{0.4, 0.1}, -0.4});
  const double of_rigid = domain.contact.kinetic_energy(); // with which the ledger does not begin
  Stepper stepper(domain, 0.0, quiet_ground());
  const Momentum before = momentum_of(domain);
  double least = 0.0;
  double largest = 0.0;
  while (stepper.time() < 0.4) {
    stepper.step();
    least = std::min(least, domain.props.all()[0].spring.force());
    largest = std::max(largest, domain.props.all()[0].spring.force());
  }
  EXPECT_GT(largest, 1e4);
  EXPECT_LT(least, -5e3);
  const Momentum after = momentum_of(domain);
  const double scale = mass_a * 0.4;
  EXPECT_NEAR(after.linear.x, before.linear.x, 1e-10 * scale);
  EXPECT_NEAR(after.linear.y, before.linear.y, 1e-10 * scale);
  EXPECT_NEAR(after.angular, before.angular, 1e-9 * scale);
  const double at_start = of_rigid + domain.energy.kinetic_start;
  EXPECT_NEAR(domain.energy.residual(), of_rigid, 0.01 * at_start);
  RecordProperty("residual", std::to_string((domain.energy.residual() - of_rigid) / at_start));
}

TEST_P(AnyPair, SwingsAtItsFrequency) {
  Domain domain(pair(GetParam().first, GetParam().second));
  part(domain, 0.1);
  Stepper stepper(domain, 0.0, quiet_ground());
  const double omega = std::sqrt(stiffness / reduced_mass);
  double last = 0.0;
  double crossed = 0.0; // when it has gone half of its period
  while (crossed == 0.0) {
    stepper.step();
    const double stretch = domain.props.all()[0].spring.stretch();
    if (last > 0.0 && stretch <= 0.0)
      crossed = stepper.time() - stepper.dt() * stretch / (stretch - last);
    last = stretch;
  }
  EXPECT_NEAR(crossed * omega / std::acos(-1.0), 1.0, 0.01); // elastic bodies give way by 1/E beside 1/k
}

TEST_P(AnyPair, IsStableWhereThePropSetsTheStep) {
  Spec spec = pair(GetParam().first, GetParam().second, 0.4, -0.3);
  spec.props.front().stiffness = 5e11;
  spec.scheme.fraction = 1.0;
  Domain domain(spec);
  part(domain, 1e-3);
  const double at_start = 0.5 * reduced_mass * 1e-6;
  Stepper stepper(domain, 0.0, quiet_ground());
  double largest = 0.0;
  for (int n = 0; n < 4000; ++n) {
    stepper.step();
    largest = std::max(largest, domain.energy.kinetic);
  }
  EXPECT_DOUBLE_EQ(stepper.dt(), domain.props.critical_step());
  // A leapfrog's velocities swing with 1/(1 - omega^2 dt^2/4) of the energy at most.
  EXPECT_LT(largest, (1.0 + 1e-6) * 4.0 / 3.0 * at_start);
}

INSTANTIATE_TEST_SUITE_P(Bodies, AnyPair,
                         testing::Values(std::pair{false, false}, std::pair{false, true},
                                         std::pair{true, true}),
                         [](const auto& pair_of) {
                           return std::string(pair_of.param.first ? "Elastic" : "Rigid") +
                                  (pair_of.param.second ? "Elastic" : "Rigid");
                         });

TEST(FloatingPair, RefusesAStepThatItsPropDoesNotAllow) {
  Spec spec = pair(false, false);
  spec.props.front().stiffness = 5e11;
  spec.scheme.dt = 1e-4;
  Domain domain(spec);
  EXPECT_THROW(Stepper(domain, 0.0, quiet_ground()).step(), std::invalid_argument);
}

TEST(FloatingPair, GoesOnFromACheckpointWithTheSameBits) {
  Spec spec = pair(false, true, 0.4, -0.3);
  spec.props.front().yield = 2e3;
  spec.props.front().bears = Bears::tension;
  Domain domain(spec);
  part(domain, 0.3);
  Stepper stepper(domain, 0.0, quiet_ground());
  for (int n = 0; n < 300; ++n)
    stepper.step();
  test_support::SavedState saved;
  save(domain, saved);
  stepper.save(saved);
  Domain again(spec);
  restore(again, saved);
  Stepper onward(again, 0.0, quiet_ground());
  onward.restore(saved);
  for (int n = 0; n < 300; ++n) {
    stepper.step();
    onward.step();
  }
  EXPECT_GT(domain.energy.plastic, 0.0);
  EXPECT_EQ(domain.props.all()[0].spring.stretch(), again.props.all()[0].spring.stretch());
  EXPECT_EQ(domain.contact.bodies()[0].state(), again.contact.bodies()[0].state());
}

} // namespace
} // namespace tremolo::mpm_domain
