// Rigid bodies that meet each other away from the soil: momentum is exact, energy is never gained, nothing
// overlaps.

#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::overlap;
using test_support::quiet_ground;
using test_support::rectangle;
using test_support::set_bodies;
using test_support::structure;
using test_support::turned;

struct Totals {
  double x = 0.0, y = 0.0, turn = 0.0, energy = 0.0, size = 0.0;
};

Totals totals(const Domain& domain) {
  Totals t;
  for (const RigidBody& body : domain.contact.bodies()) {
    const Vector v = body.motion().velocity;
    t.x += body.mass() * v.x;
    t.y += body.mass() * v.y;
    t.turn += body.inertia() * body.motion().spin + body.mass() * cross(body.centre(), v);
    t.energy += body.kinetic_energy();
    t.size += body.mass() * std::hypot(v.x, v.y);
  }
  return t;
}

TEST(Collision, KeepsMomentumGainsNoEnergyAndLetsNothingOverlap) {
  for (const double friction : {0.0, 0.6})
    for (const double lean : {0.0, 0.2, 0.7}) {
      Spec spec = flat_ground(8.0, 2.0, 0.5, {2000.0, 1e8, 0.2});
      spec.gravity = 0.0;
      spec.structures = {structure(rectangle(-3.0, 3.0, -1.0, 6.0), 2000.0, friction),
                         structure(turned(rectangle(0.0, 3.5, 1.0, 5.5), {0.5, 4.5}, lean), 500.0, friction)};
      Domain domain(spec);
      Stepper stepper(domain, 0.0, quiet_ground());
      const auto position = [&](std::size_t b) { return domain.contact.bodies()[b].centre(); };
      set_bodies(domain, {{position(0).x, position(0).y, 0.0, 2.0, 0.1, 0.05},
                          {position(1).x, position(1).y, 0.0, -1.0, 0.0, -0.2}});
      const Totals start = totals(domain);
      double energy = start.energy;
      double deepest = 0.0;
      while (stepper.time() < 1.0) {
        stepper.step();
        const Totals now = totals(domain);
        EXPECT_LE(now.energy, energy * (1.0 + 1e-12));
        energy = now.energy;
        deepest = std::max(deepest, overlap(domain.contact.bodies()[0], domain.contact.bodies()[1]));
      }
      const Totals end = totals(domain);
      EXPECT_NEAR(end.x, start.x, 1e-14 * start.size);
      EXPECT_NEAR(end.y, start.y, 1e-14 * start.size);
      EXPECT_NEAR(end.turn, start.turn, 2e-3 * start.size); // places move by explicit steps
      EXPECT_LT(end.energy, 0.99 * start.energy);           // they have met
      EXPECT_LT(deepest, 0.01);
      const EnergyLedger& ledger = domain.energy;
      EXPECT_NEAR(ledger.friction + ledger.impact, start.energy - end.energy, 1e-9 * start.energy);
    }
}

} // namespace
} // namespace tremolo::mpm_domain
