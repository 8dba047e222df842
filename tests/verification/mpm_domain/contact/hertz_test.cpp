// A rigid cylinder on an elastic half-space presses on it as Hertz (1882) has it in plane strain: with P the
// force and E* = E/(1 - nu^2), the half width of the contact is b = sqrt(4 P R/(pi E*)), its pressure p0
// sqrt(1 - x^2/b^2), p0 = sqrt(P E*/(pi R)). The cylinder bounces so slowly that this holds with the force of
// any time.

#include "mpm_domain/particles/fill/rest_stress.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace tremolo::mpm_domain {
namespace {

using test_support::circle;
using test_support::flat_ground;
using test_support::structure;

/// @param h    side of the cells, m
/// @param end  s
void expect_pressure(double h, double end) {
  constexpr double radius = 8.0;               // m
  constexpr double young = 1e7, poisson = 0.3; // Pa
  const double modulus = young / (1.0 - poisson * poisson);
  Spec spec = flat_ground(3.0 * radius, 1.5 * radius, h, {1000.0, young, poisson});
  spec.sides = Sides::periodic;
  spec.below_base = materials::Elasticity{2600.0, 1e13, 0.2};
  spec.soils.front().damping_time = 2e-3;
  spec.structures = {structure(circle({0.0, radius}, radius, 256), 2000.0, 0.0)};
  Domain domain(spec);
  set_rest_stress(domain.sets, domain.spec);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  double worst_width = 0.0;    // error of b, m
  double worst_pressure = 0.0; // error of p0, relative
  for (int look = 0; 0.4 + 0.1 * look < end + 1e-9; ++look) {
    while (stepper.time() < 0.4 + 0.1 * look)
      stepper.step();
    const double middle = domain.contact.bodies().front().centre().x;
    double force = 0.0;
    double second = 0.0;
    std::map<double, double> columns; // force on the nodes above one another, by x
    for (const ContactNode& c : domain.contact.nodes(0)) {
      const double up = c.normal_impulse / stepper.kick() * c.normal.y;
      force += up;
      second += up * std::pow(c.position.x - middle, 2);
      columns[c.position.x - middle] += up;
    }
    const double b = std::sqrt(4.0 * force * radius / (std::numbers::pi * modulus));
    const double p0 = std::sqrt(force * modulus / (std::numbers::pi * radius));
    // The second moment of the profile is b^2/4; hats of nodes add h^2/6.
    const double width = 2.0 * std::sqrt(second / force - h * h / 6.0);
    double pressed = 0.0;
    double exact = 0.0;
    for (const auto& [x, up] : columns)
      if (std::abs(x) < 0.5 * b) {
        pressed += up / h;
        exact += p0 * std::sqrt(1.0 - x * x / (b * b));
      }
    worst_width = std::max(worst_width, std::abs(width - b));
    worst_pressure = std::max(worst_pressure, std::abs(pressed / exact - 1.0));
  }
  EXPECT_LT(worst_width, 0.25);
  EXPECT_LT(worst_pressure, 0.1);
  testing::Test::RecordProperty("error_of_width", std::to_string(worst_width));
  testing::Test::RecordProperty("error_of_pressure", std::to_string(worst_pressure));
}

TEST(Hertz, PressureUnderACylinder) {
  expect_pressure(0.5, 0.5);
}

TEST(Hertz, AcceptancePressureForASecond) {
  expect_pressure(0.5, 1.0);
}

TEST(Hertz, AcceptancePressureOnCellsOfHalfTheSize) {
  expect_pressure(0.25, 1.0);
}

} // namespace
} // namespace tremolo::mpm_domain
