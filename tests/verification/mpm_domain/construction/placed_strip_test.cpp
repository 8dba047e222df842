// A flat strip of soft soil of width B that is placed on the ground presses it as a load q = gamma t does:
//
//     sigma_v/q = (a + sin a)/pi,      a = 2 atan(B/2z),
//
// under its middle, in a half-space.

#include "tests/verification/mpm_domain/construction/stages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace tremolo::mpm_domain::test {
namespace {

constexpr double width = 80.0;
constexpr double strip = 8.0; // B
constexpr double residual = 1e-5;

Region ground() {
  return layer(width, -40.0, 0.0);
}

Spec with_strip() {
  Spec spec = level_ground(width, 40.0, 2.0, 1.0);
  spec.sides = Sides::free_field;
  spec.soils.push_back(spec.soils.front());
  spec.soils.back().law = materials::LinearElastic{{2500.0, 2e5, 0.0}}; // carries its weight, and no more
  const double left = 0.5 * (width - strip);
  spec.regions = {ground(), {1, {{left, 0.0}, {left + strip, 0.0}, {left + strip, 2.0}, {left, 2.0}}}};
  return spec;
}

TEST(PlacedStrip, PressesTheGroundAsALoadDoes) {
  Domain domain(with_strip());
  const StaticStage position = construction({ground()}, residual, 20.0);
  rest(domain, {&position, 1}, residual);
  const double q = 2500.0 * gravity * 2.0;
  const Particles& p = domain.sets.front();
  for (const double z : {2.0, 4.0, 8.0}) {
    double share = 0.0;
    for (std::size_t k = 0; k < p.size(); ++k)
      if (std::abs(p.x[k] - 0.5 * width) < 0.3 && std::abs(p.y[k] + z) < 0.3)
        share -= 0.25 * (p.syy[k] - density * gravity * p.y[k]) / q;
    const double a = 2.0 * std::atan(strip / (2.0 * z));
    const double exact = (a + std::sin(a)) / std::numbers::pi;
    RecordProperty("z = " + std::to_string(z), std::to_string(share) + " for " + std::to_string(exact));
    EXPECT_NEAR(share, exact, 0.04 * exact) << "z = " << z;
  }
}

TEST(PlacedStrip, LeavesNothingBehindWhenItIsRemoved) {
  Spec spec = with_strip();
  const std::vector<Region> strip_stands = spec.regions;
  spec.regions.pop_back();
  Domain domain(spec);
  const std::vector<StaticStage> stages{construction({ground()}, residual, 5.0),
                                        construction(strip_stands, residual, 5.0)};
  rest(domain, stages, residual);
  const double q = 2500.0 * gravity * 2.0;
  const Particles& p = domain.sets.front();
  for (std::size_t k = 0; k < p.size(); ++k)
    EXPECT_NEAR(p.syy[k], density * gravity * p.y[k], 0.01 * q);
}

} // namespace
} // namespace tremolo::mpm_domain::test
