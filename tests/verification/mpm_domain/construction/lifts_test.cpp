// Level ground that is placed and removed in lifts. A lift of unit weight gamma and height h settles by what
// it does to the soil below it, and later by what comes onto it: soil at y of a lift from y_b to y_t, in
// ground of height H,
//
//     u_y = -(gamma h y_b + gamma (H - y_t) y)/M,
//
// while the stress is gamma (y - H) at last, whatever the lifts, with K0 = nu/(1 - nu).

#include "tests/verification/mpm_domain/construction/stages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tremolo::mpm_domain::test {
namespace {

constexpr double height = 10.0;
constexpr double width = 1.0;
constexpr double residual = 1e-9;

/// Ground from y = 0 in so many lifts.
struct Built {
  Domain domain;

  explicit Built(int lifts, double ramp = 2.0) : domain(level_ground(width, 0.0, height, 0.5)) {
    std::vector<StaticStage> stages;
    for (int lift = 1; lift < lifts; ++lift)
      stages.push_back(construction({layer(width, 0.0, lift * height / lifts)}, residual, ramp));
    rest(domain, stages, residual);
  }
  const Particles& soil() const { return domain.sets.front(); }
};

TEST(Lifts, SettleByWhatComesLater) {
  for (const int lifts : {2, 5, 10}) {
    const Built ground(lifts);
    const double h = height / lifts;
    const double gamma = density * gravity;
    const Particles& p = ground.soil();
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double bottom = h * std::floor(p.y[k] / h);
      const double below = bottom == 0.0 ? 0.0 : h * bottom; // the first one is that of the gravity stage
      const double exact = -gamma * (below + (height - bottom - h) * p.y[k]) / modulus;
      EXPECT_NEAR(p.y[k] - p.y_initial[k], exact, 0.002 * 25e-3) << lifts << " lifts, y = " << p.y[k];
      EXPECT_NEAR(p.x[k], p.x_initial[k], 1e-9);
    }
  }
}

TEST(Lifts, LeaveTheStressOfTheirWeight) {
  for (const int lifts : {1, 4}) {
    const Built ground(lifts);
    const Particles& p = ground.soil();
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double exact = density * gravity * (p.y[k] - height);
      EXPECT_NEAR(p.syy[k], exact, 1e-6 * density * gravity * height) << lifts << " lifts, y = " << p.y[k];
      EXPECT_NEAR(p.sxx[k], poisson / (1.0 - poisson) * exact, 1e-6 * density * gravity * height);
    }
  }
}

TEST(Lifts, OfElasticSoilDoNotDependOnTheRamp) {
  const Built slow(4, 4.0);
  const Built fast(4, 0.01);
  for (std::size_t k = 0; k < slow.soil().size(); ++k)
    EXPECT_NEAR(slow.soil().syy[k], fast.soil().syy[k], 1e-6 * density * gravity * height);
}

/// Ground of 10 m below 5 m that are removed: q = gamma 5 m.
struct DugOut {
  Domain domain;
  double q = density * gravity * 5.0;

  explicit DugOut(double residual_) : domain(spec()) {
    const StaticStage dig = construction({layer(width, -height, 5.0)}, residual_);
    rest(domain, {&dig, 1}, residual_);
  }
  static Spec spec() {
    Spec spec = level_ground(width, height, 5.0, 0.5);
    spec.regions = {layer(width, -height, 0.0)};
    return spec;
  }
};

// u_y = q (y + H)/M: 50 mm at the surface
TEST(Excavation, LetsTheGroundRise) {
  const DugOut dug(residual);
  const Particles& p = dug.domain.sets.front();
  double highest = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_NEAR(p.y[k] - p.y_initial[k], dug.q * (p.y[k] + height) / modulus, 0.002 * 50e-3);
    EXPECT_NEAR(p.syy[k], density * gravity * p.y[k], 1e-6 * dug.q);
    highest = std::max(highest, p.y[k] - p.y_initial[k]);
  }
  EXPECT_NEAR(highest * 10.0 / 9.875, 50e-3, 0.002 * 50e-3);
}

// The soil that has gone is placed again: it comes with the stress of its own weight, and what lies below it
// is where it was.
TEST(Excavation, IsUndoneByFillingUp) {
  Spec spec = level_ground(width, height, 5.0, 0.5);
  const std::vector<StaticStage> stages{construction({layer(width, -height, 5.0)}, residual),
                                        construction({layer(width, -height, 0.0)}, residual)};
  Domain domain(spec);
  rest(domain, stages, residual);
  const Particles& p = domain.sets.front();
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_NEAR(p.syy[k], density * gravity * (p.y[k] - 5.0), 1e-6 * density * gravity * 15.0);
    if (p.y[k] < 0.0) {
      EXPECT_NEAR(p.y[k], p.y_initial[k], 1e-6);
    }
  }
}

TEST(Construction, OfNothingMovesNothing) {
  Spec spec = level_ground(width, height, 0.0, 0.5);
  Domain before(spec);
  const Reactions held = rest(before, {}, residual);
  Domain after(spec);
  const StaticStage nothing = construction(spec.regions, residual);
  const Reactions again = rest(after, {&nothing, 1}, residual);
  const double weight = density * gravity * height * width;
  for (std::size_t n = 0; n < held.force.size(); ++n) {
    EXPECT_NEAR(held.force[n].x, again.force[n].x, 1e-9 * weight);
    EXPECT_NEAR(held.force[n].y, again.force[n].y, 1e-9 * weight);
  }
  for (std::size_t k = 0; k < before.sets.front().size(); ++k) {
    EXPECT_NEAR(before.sets.front().syy[k], after.sets.front().syy[k], 1e-9 * density * gravity * height);
    EXPECT_NEAR(after.sets.front().y[k], after.sets.front().y_initial[k], 1e-12);
  }
}

} // namespace
} // namespace tremolo::mpm_domain::test
