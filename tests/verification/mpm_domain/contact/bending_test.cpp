// An elastic tower on rock bends as a beam does: the period of its first mode is Timoshenko's cantilever's.

#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::rectangle;
using test_support::StandingScene;
using test_support::structure;

constexpr double width = 1.0, height = 6.0;                           // m
constexpr double density = 2000.0, young = 5e8, poisson = 0.3;        // kg/m3, Pa
constexpr double modulus = young / (1.0 - poisson * poisson);         // of plane strain, Pa
constexpr double inertia = width * width * width / 12.0;              // m3
constexpr double shear = 5.0 / 6.0 * young / (2.0 * (1.0 + poisson)); // kappa G, Pa

/// First natural period, s, by Dunkerley's rule: that of bending, 3.516/L^2 sqrt(E I/(rho A)), and that of
/// shear, pi/2 sqrt(kappa G/rho)/L, whose squares add up; rotary inertia is a hundredth of that; the weight
/// takes its share of the weight under which the tower would buckle, 7.837 E I/L^2, off the stiffness.
double period() {
  const double bending = 3.516 / (height * height) * std::sqrt(modulus * inertia / (density * width));
  const double shearing = 0.5 * std::numbers::pi * std::sqrt(shear / density) / height;
  const double weight = density * width * height * 9.81;
  const double buckling = 7.837 * modulus * inertia / (height * height);
  const double squared = 1.0 / (1.0 / (bending * bending) + 1.0 / (shearing * shearing));
  return 2.0 * std::numbers::pi / std::sqrt(squared * (1.0 - weight / buckling));
}

/// Its period over that, in cells of some size, m.
double measured(double h) {
  Spec spec = flat_ground(4.0, 1.0, h, {density, 2e10, 0.2});
  spec.structures = {structure(rectangle(-0.5 * width, 0.0, 0.5 * width, height), density, 1.0)};
  spec.structures.front().stiffness = Stiffness{young, poisson};
  StandingScene scene(spec);
  // A push along its first mode, as a parabola has it, that leaves all of its base pressed to the rock.
  for (Particles& set : scene.domain.sets)
    for (std::size_t k = 0; set.body && k < set.size(); ++k) {
      const double rise = set.y[k] / height;
      set.vx[k] = 1e-3 * rise * rise;
    }
  const auto top = [&] {
    double sum = 0.0;
    for (const Particles& set : scene.domain.sets)
      for (std::size_t k = 0; set.body && k < set.size(); ++k)
        if (set.y_initial[k] > height - 0.25)
          sum += set.x[k] - set.x_initial[k];
    return sum;
  };
  std::vector<double> crossings; // s
  double before = 0.0;
  while (crossings.size() < 3 && scene.stepper.time() < 2.0 * period()) {
    scene.stepper.step();
    const double now = top();
    if (before * now < 0.0)
      crossings.push_back(scene.stepper.time() - scene.stepper.dt() * now / (now - before));
    before = now;
  }
  return crossings.size() < 3 ? 0.0 : (crossings[2] - crossings[0]) / period();
}

TEST(Tower, BendsWithTheBeamsPeriod) {
  const double two = measured(0.5); // cells across
  const double four = measured(0.25);
  RecordProperty("two_cells", std::to_string(two));
  RecordProperty("four_cells", std::to_string(four));
  EXPECT_NEAR(four, 1.0, 0.02);
}

} // namespace
} // namespace tremolo::mpm_domain
