// Soil at rest under its weight for seconds on three levels whose cells meet in re-entrant corners, held
// by the tractions and dashpots of its faces.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/hard_case.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

Spec corners() {
  Spec spec = elastic_box(10.0, 8.0, 1.0);
  spec.gravity = 9.81;
  spec.threads = 1;
  spec.refine = {{{2.0, -6.0, 8.0, -4.0}, 1},
                 {{2.0, -4.0, 5.0, 0.0}, 1},
                 {{3.0, -5.0, 4.0, -3.0}, 2},
                 {{4.0, -5.0, 6.0, -4.5}, 2}};
  return spec;
}

void expect_rest(double end) {
  Domain domain(corners());
  replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
  Stepper stepper(domain, 0.0, quiet_ground());
  double smallest_mass = 0.0;
  double smallest_weight = 0.0;
  double fastest = 0.0;
  while (stepper.time() < end) {
    stepper.step();
    if (stepper.steps() % 64 != 0)
      continue;
    smallest_mass = std::min(smallest_mass, *std::ranges::min_element(domain.grid.mass));
    for (const Particles& p : domain.sets)
      for (std::size_t k = 0; k < p.size(); ++k)
        fastest = std::max(fastest, std::hypot(p.vx[k], p.vy[k]));
    for (const auto& [tile, set, weights, sums] : domain.clock_tiles.front().across)
      for (std::size_t k = weights.first(); k < weights.end(); ++k)
        for (const FourWeights& w : weights.of(k))
          smallest_weight = std::min({smallest_weight, w.s[0], w.s[1], w.s[2], w.s[3]});
  }
  bounded("mass below zero of any node", -smallest_mass, 1e-12, "kg/m");
  bounded("weight below zero", -smallest_weight, 1e-14);
  bounded("largest speed", fastest, 1e-5, "m/s");
}

TEST(HardCase12ReentrantCorners, ThreeLevelsWithReentrantCornersRestUnderGravity) {
  expect_rest(3.0);
}

TEST(HardCase12ReentrantCorners, AcceptanceRestForTenSeconds) {
  expect_rest(10.0);
}

} // namespace
} // namespace tremolo::mpm_domain
