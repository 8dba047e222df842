// Cuts through bodies whose particles have the stress of a closed form: whatever their direction and wherever
// they lie between nodes, N, Q and M are those of the stress.

#include "floating_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test::floating;
using test_support::rectangle;
using test_support::structure;
using test_support::turned;

constexpr Stiffness stiffness{2e8, 0.2};

struct PlaneStress {
  double xx, yy, xy; ///< Pa
};

void set_stress(Domain& domain, const std::function<PlaneStress(const Vector&)>& stress) {
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; set.body && k < set.size(); ++k) {
      const PlaneStress s = stress({set.x[k], set.y[k]});
      set.sxx[k] = s.xx;
      set.syy[k] = s.yy;
      set.sxy[k] = s.xy;
    }
}

TEST(Cut, SharesOfASquareAheadOfALineAreThoseOfItsArea) {
  for (const double degrees : {0.0, 1e-5, 17.0, 45.0, 90.0, 200.0}) {
    const Vector n{std::cos(degrees * std::numbers::pi / 180.0),
                   std::sin(degrees * std::numbers::pi / 180.0)};
    for (const double ahead : {-0.4, -0.1, 0.0, 0.03, 0.25, 0.5}) {
      constexpr int parts = 1000;
      int inside = 0;
      for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j)
          inside +=
              ahead + n.x * 0.5 * ((i + 0.5) / parts - 0.5) + n.y * 0.5 * ((j + 0.5) / parts - 0.5) > 0.0;
      EXPECT_NEAR(share_ahead(ahead, n, 0.5), static_cast<double>(inside) / parts / parts, 2e-3)
          << degrees << " " << ahead;
    }
  }
}

/// A cantilever 1 m high with a force on its end, in the direction of its length at an angle to the grid
/// (Timoshenko and Goodier 1970, section 21).
class Beam : public testing::TestWithParam<double> {};

TEST_P(Beam, HasTheForcesOfItsStress) {
  const double angle = GetParam() * std::numbers::pi / 180.0;
  constexpr double length = 5.0, height = 1.0, pull = 3e4, shear = 1e4; // m, N/m
  constexpr double inertia = height * height * height / 12.0;
  const Vector centre{0.0, 4.0};
  const Vector axis{std::cos(angle), std::sin(angle)};
  const Vector up{-axis.y, axis.x};
  const auto at = [&](double along, double above) {
    return Vector{centre.x + along * axis.x + above * up.x, centre.y + along * axis.y + above * up.y};
  };
  std::vector<CutLine> cuts;
  const std::vector<double> positions{-1.03, -0.4, 0.0, 0.11, 0.9};
  for (const double x : positions)
    cuts.push_back({at(x, 0.5 * height), at(x, -0.5 * height)}); // the axis to the left, M stretches below
  Structure body = structure(
      turned(rectangle(-0.5 * length, 4.0 - 0.5 * height, 0.5 * length, 4.0 + 0.5 * height), centre, angle),
      2000.0, 0.5);
  Spec spec = floating(std::move(body), stiffness, cuts, 0.25);
  spec.particles_per_cell =
      4; // n of them over a height give M with an error of 1/n^2, as their stress is given
  Domain domain(spec);
  // Downwards on the right end, which lies ahead: M = -shear (L/2 - x), tension above.
  set_stress(domain, [&](const Vector& x) {
    const Vector d{x.x - centre.x, x.y - centre.y};
    const double above = dot(d, up);
    const double along = pull / height + shear * (0.5 * length - dot(d, axis)) * above / inertia;
    const double across = -shear / (2.0 * inertia) * (0.25 * height * height - above * above);
    return PlaneStress{along * axis.x * axis.x + 2.0 * across * axis.x * up.x,
                       along * axis.y * axis.y + 2.0 * across * axis.y * up.y,
                       along * axis.x * axis.y + across * (axis.x * up.y + axis.y * up.x)};
  });
  double worst = 0.0;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const SectionForces found = forces(domain, domain.sections.all()[0], k);
    const double moment = -shear * (0.5 * length - positions[k]);
    EXPECT_NEAR(found.axial, pull, 0.01 * pull);
    EXPECT_NEAR(found.shear, -shear, 0.01 * shear);
    EXPECT_NEAR(found.moment, moment, 0.01 * std::abs(moment));
    worst = std::max({worst, std::abs(found.axial / pull - 1.0), std::abs(found.shear / shear + 1.0),
                      std::abs(found.moment / moment - 1.0)});
  }
  RecordProperty("worst", std::to_string(worst));
}
INSTANTIATE_TEST_SUITE_P(Degrees, Beam, testing::Values(0.0, 20.0, 45.0, 90.0, 160.0));

/// A cut that goes with a body turned by a right angle and carried along.
TEST(Cut, GoesWithItsBody) {
  const std::vector<CutLine> cuts{{{-0.2, 3.0}, {0.1, 5.0}}};
  Domain domain(floating(structure(rectangle(-2.0, 3.0, 2.0, 5.0), 2000.0, 0.5), stiffness, cuts, 0.5));
  const CutPosition before = position_of(domain, domain.sections.all()[0], 0, 0.0);
  EXPECT_NEAR(before.middle.x, -0.05, 1e-12);
  EXPECT_NEAR(before.middle.y, 4.0, 1e-12);
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; set.body && k < set.size(); ++k) {
      const Vector d{set.x[k], set.y[k] - 4.0};
      set.x[k] = 0.3 - d.y;
      set.y[k] = 4.1 + d.x;
      set.vx[k] = 2.0;
    }
  const CutPosition now = position_of(domain, domain.sections.all()[0], 0, 0.1);
  EXPECT_NEAR(now.middle.x, 0.3 - 0.2, 1e-12);
  EXPECT_NEAR(now.middle.y, 4.1 - 0.05, 1e-12);
  EXPECT_NEAR(now.along.x, -before.along.y, 1e-12);
  EXPECT_NEAR(now.along.y, before.along.x, 1e-12);
}

TEST(Sections, NeedAnElasticStructureThatTheyCut) {
  const auto made = [](const std::vector<CutLine>& cuts, bool elastic, const char* of) {
    Spec spec = floating(structure(rectangle(-2.0, 3.0, 2.0, 5.0), 2000.0, 0.5), stiffness, cuts, 0.5);
    if (!elastic)
      spec.structures.front().stiffness.reset();
    spec.sections.front().structure = of;
    const Domain domain(spec);
  };
  const std::vector<CutLine> good{{{0.0, 3.0}, {0.0, 5.0}}};
  EXPECT_NO_THROW(made(good, true, "block"));
  EXPECT_THROW(made(good, false, "block"), std::invalid_argument);
  EXPECT_THROW(made(good, true, "wall"), std::invalid_argument);
  EXPECT_THROW(made({{{4.0, 3.0}, {4.0, 5.0}}}, true, "block"), std::invalid_argument);
  EXPECT_THROW(made({{{0.0, 3.0}, {0.0, 3.0}}}, true, "block"), std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain
