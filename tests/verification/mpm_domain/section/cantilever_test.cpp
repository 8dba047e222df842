// Cantilevers: a tower on rock under its weight, and a beam that a force in its middle and others on both of
// its ends hold in balance, each half of which is a cantilever with a force on its end.

#include "floating_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test::PlacedForce;
using test_support::flat_ground;
using test_support::rectangle;
using test_support::structure;

TEST(Cantilever, BearsItsWeight) {
  constexpr double width = 1.0, height = 6.0, density = 2000.0; // m, kg/m3
  Spec spec = flat_ground(4.0, 1.0, 0.25, {density, 2e10, 0.2});
  spec.structures = {structure(rectangle(-0.5 * width, 0.0, 0.5 * width, height), density, 1.0)};
  spec.structures.front().stiffness = Stiffness{5e8, 0.3};
  const std::vector<double> levels{0.5, 1.0, 2.1, 3.0, 4.43};
  for (const double y : levels) // the axis runs upwards
    spec.sections.push_back({"", "block", {{{-0.5 * width, y}, {0.5 * width, y}}}});
  const test_support::StandingScene scene(spec);
  double worst = 0.0;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const SectionForces found = forces(scene.domain, scene.domain.sections.all()[k], 0);
    const double axial = -density * spec.gravity * width * (height - levels[k]);
    EXPECT_NEAR(found.axial, axial, 1e-3 * std::abs(axial)) << levels[k];
    EXPECT_NEAR(found.shear, 0.0, 1e-6 * std::abs(axial)) << levels[k];
    EXPECT_NEAR(found.moment, 0.0, 1e-6 * std::abs(axial)) << levels[k];
    worst = std::max(worst, std::abs(found.axial / axial - 1.0));
  }
  RecordProperty("worst", std::to_string(worst));
}

TEST(Cantilever, HasTheForcesOfAForceOnItsEnd) {
  constexpr double half = 3.0, height = 1.0, young = 2e8, poisson = 0.2; // m, Pa
  constexpr double pull = 2e3, push = 1e3;                               // on each end, N/m
  const Vector middle{0.0, 4.0};
  const Vector force{pull, -push}; // on the right end
  const std::vector<CutLine> cuts{ // from above: the axis runs to the right
                                  {{0.75, 4.5}, {0.75, 3.5}},
                                  {{1.3, 4.5}, {1.3, 3.5}},
                                  {{2.11, 4.5}, {2.11, 3.5}},
                                  {{1.0, 4.5}, {1.6, 3.5}},
                                  {{1.9, 4.5}, {1.5, 3.5}}};
  Domain domain(test::floating(
      structure(rectangle(-half, middle.y - 0.5 * height, half, middle.y + 0.5 * height), 2000.0, 0.5),
      {young, poisson}, cuts, 0.25));
  std::vector<PlacedForce> forces_on;
  for (const double above : {-0.375, -0.125, 0.125, 0.375}) {
    const double y = middle.y + above;
    forces_on.push_back({{half - 0.01, y}, {0.25 * force.x, 0.25 * force.y}});
    forces_on.push_back({{-half + 0.01, y}, {-0.25 * force.x, 0.25 * force.y}});
    forces_on.push_back({{0.0, y}, {0.0, -0.5 * force.y}});
  }
  const double omega = 22.37 / (4.0 * half * half) * height *
                       std::sqrt(young / (1.0 - poisson * poisson) / (12.0 * 2000.0)); // of a free beam
  test::pull_to_rest(domain, forces_on, omega, 14.0 / omega);
  double worst = 0.0;
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const SectionForces found = forces(domain, domain.sections.all()[0], k);
    const Vector at{0.5 * (cuts[k].from.x + cuts[k].to.x), middle.y};
    const double length = std::hypot(cuts[k].to.x - cuts[k].from.x, height);
    const Vector along{(cuts[k].to.x - cuts[k].from.x) / length, -height / length};
    const double axial = dot(force, {-along.y, along.x});
    const double shear = -dot(force, along);
    const double moment = cross({half - 0.01 - at.x, 0.0}, force);
    EXPECT_NEAR(found.axial, axial, 0.02 * std::abs(axial)) << k;
    EXPECT_NEAR(found.shear, shear, 0.02 * std::abs(shear)) << k;
    EXPECT_NEAR(found.moment, moment, 0.02 * std::abs(moment)) << k;
    worst = std::max({worst, std::abs(found.axial / axial - 1.0), std::abs(found.shear / shear - 1.0),
                      std::abs(found.moment / moment - 1.0)});
  }
  RecordProperty("worst", std::to_string(worst));
}

} // namespace
} // namespace tremolo::mpm_domain
