// Free rings at rest under forces: section forces are those of the closed forms.

#include "floating_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test::PlacedForce;
using test_support::circle;
using test_support::structure;

const Vector centre{0.0, 4.0};

Structure ring(double inner, double outer) {
  Structure body = structure(circle(centre, outer), 2000.0, 0.5);
  body.hole = circle(centre, inner);
  return body;
}

/// Two forces P pull it apart along the vertical diameter. With phi from the horizontal one, R the radius of
/// the axis and e = R - t/ln(b/a), the thick curved beam has (Winkler; Timoshenko 1955, section 80)
///
///     N = P/2 cos phi,   Q = -P/2 sin phi,   M = -P R/2 (cos phi - 2/pi + 2 e/(pi R)).
TEST(Ring, HasTheForcesOfTwoOppositeForces) {
  constexpr double inner = 2.5, outer = 3.5, radius = 3.0, thickness = 1.0, pull = 1e4; // m, N/m
  constexpr double young = 2e8, poisson = 0.2;
  const std::vector<double> degrees{0.0, 15.0, 30.0, 45.0, 60.0, 180.0, 225.0};
  Domain domain(test::floating(ring(inner, outer), {young, poisson},
                               test::cuts_around(centre, inner, outer, degrees), 0.25));
  std::vector<PlacedForce> forces_on;
  for (const double side : {-1.0, 1.0}) // spread over the thickness, so that no node is light
    for (const double r : {2.7, 2.85, 3.0, 3.15, 3.3})
      forces_on.push_back({{centre.x, centre.y + side * r}, {0.0, side * pull / 5.0}});
  // The frequency of ovaling is 2.68 sqrt(EI/(rho t R^4)).
  const double omega = 2.68 / (radius * radius) *
                       std::sqrt(young / (1.0 - poisson * poisson) * thickness * thickness / (12.0 * 2000.0));
  test::pull_to_rest(domain, forces_on, omega, 14.0 / omega);
  const double e = radius - thickness / std::log(outer / inner);
  const auto moment_at = [&](double phi) {
    return -0.5 * pull * radius *
           (std::cos(phi) - 2.0 / std::numbers::pi + 2.0 * e / (std::numbers::pi * radius));
  };
  const double largest = moment_at(0.5 * std::numbers::pi);
  double worst_force = 0.0;
  double worst_moment = 0.0;
  for (std::size_t k = 0; k < degrees.size(); ++k) {
    const SectionForces found = forces(domain, domain.sections.all()[0], k);
    const double phi = (degrees[k] < 180.0 ? degrees[k] : degrees[k] - 180.0) * std::numbers::pi / 180.0;
    const double axial = 0.5 * pull * std::cos(phi);
    const double shear = -0.5 * pull * std::sin(phi);
    EXPECT_NEAR(found.axial, axial, 0.01 * pull) << degrees[k];
    EXPECT_NEAR(found.shear, shear, 0.01 * pull) << degrees[k];
    EXPECT_NEAR(found.moment, moment_at(phi), 0.02 * largest) << degrees[k];
    worst_force = std::max({worst_force, std::abs(found.axial - axial) / (0.5 * pull),
                            std::abs(found.shear - shear) / (0.5 * pull)});
    worst_moment = std::max(worst_moment, std::abs(found.moment - moment_at(phi)) / largest);
  }
  RecordProperty("worst_force", std::to_string(worst_force));
  RecordProperty("worst_moment", std::to_string(worst_moment));
}

/// A cylinder under pressure from inside (Lame 1852): sigma_theta = s + B/r^2 with s = p a^2/(b^2 - a^2) and
/// B = s b^2, so that N = p a and M = B (ln b/a - r (1/a - 1/b)) about the middle r.
TEST(Cylinder, HasTheForcesOfPressureFromInside) {
  constexpr double inner = 2.0, outer = 3.0, middle = 2.5, pressure = 1e5; // m, Pa
  constexpr double young = 2e8, poisson = 0.2;
  std::vector<double> degrees;
  for (int k = 0; k < 24; ++k)
    degrees.push_back(15.0 * k);
  Domain domain(test::floating(ring(inner, outer), {young, poisson},
                               test::cuts_around(centre, inner, outer, degrees), 0.125));
  std::vector<PlacedForce> forces_on;
  constexpr int pieces = 2000;
  for (int k = 0; k < pieces; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + 0.5) / pieces;
    const Vector out{std::cos(angle), std::sin(angle)};
    const double push = pressure * 2.0 * std::numbers::pi * inner / pieces;
    forces_on.push_back({{centre.x + inner * out.x, centre.y + inner * out.y}, {push * out.x, push * out.y}});
  }
  const double omega = std::sqrt(young / 2000.0) / middle; // of breathing
  test::pull_to_rest(domain, forces_on, omega, 14.0 / omega);
  const double axial = pressure * inner;
  const double b = pressure * inner * inner * outer * outer / (outer * outer - inner * inner);
  const double moment = b * (std::log(outer / inner) - middle * (1.0 / inner - 1.0 / outer));
  double worst_force = 0.0;
  double worst_moment = 0.0;
  for (std::size_t k = 0; k < degrees.size(); ++k) {
    const SectionForces found = forces(domain, domain.sections.all()[0], k);
    EXPECT_NEAR(found.axial, axial, 0.02 * axial) << degrees[k];
    EXPECT_NEAR(found.shear, 0.0, 0.02 * axial) << degrees[k];
    EXPECT_NEAR(found.moment, moment, 0.02 * std::abs(moment)) << degrees[k];
    worst_force = std::max({worst_force, std::abs(found.axial / axial - 1.0), std::abs(found.shear / axial)});
    worst_moment = std::max(worst_moment, std::abs(found.moment / moment - 1.0));
  }
  RecordProperty("worst_force", std::to_string(worst_force));
  RecordProperty("worst_moment", std::to_string(worst_moment));
}

} // namespace
} // namespace tremolo::mpm_domain
