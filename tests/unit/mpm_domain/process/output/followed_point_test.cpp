// The strain of a point that output follows: exact for displacements that are linear in the place at the
// start.

#include "mpm_domain/process/output/followed_point.hpp"

#include "tests/support/box_run.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/unit/scene/case_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// Two layers of elastic soil, 8 m wide, each moved by a displacement that is linear in the place.
class MovedLayers {
public:
  MovedLayers() : at_start_(spec()), domain_(spec()), stepper_(domain_, 0.0, test_support::quiet_ground()) {
    stepper_.step();
    for (Particles& set : domain_.sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        const double x = set.x_initial[k];
        const double y = set.y_initial[k];
        const double more = set.soil == "lower" ? 3.0 : 1.0;
        set.x[k] = x + more * (1e-3 * x + 2e-3 * y);
        set.y[k] = y + more * (-5e-4 * x + 4e-3 * y);
      }
  }

  /// A value of the point nearest to x, y.
  double value(double x, double y, const std::string& column) {
    const FollowedPoint point(at_start_, at_start_.sets,
                              {x, y}); // as output does, which begins before anything moves
    std::vector<double> row;
    point.append_values(Snapshot(domain_), stepper_, false, row);
    const auto columns = FollowedPoint::columns(scene::parse(scene::testing::flat_case, "flat.toml", "."));
    EXPECT_EQ(columns.size(), row.size());
    const auto at = std::ranges::find(columns, column, &OutputColumn::name);
    return row.at(static_cast<std::size_t>(at - columns.begin()));
  }

  /// As if the particle that began at x, y had been cut.
  void forget(double x, double y) {
    for (Particles& set : domain_.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        if (std::hypot(set.x_initial[k] - x, set.y_initial[k] - y) < 1e-9)
          set.index_of.remove(set.id[k]);
  }

private:
  static Spec spec() {
    Spec spec = test_support::elastic_box(8.0, 8.0, 1.0);
    spec.soils = {{"upper", spec.soils.front().law}, {"lower", spec.soils.front().law}};
    spec.regions = {{0, {{0.0, -4.0}, {8.0, -4.0}, {8.0, 0.0}, {0.0, 0.0}}},
                    {1, {{0.0, -8.0}, {8.0, -8.0}, {8.0, -4.0}, {0.0, -4.0}}}};
    return spec;
  }

  Domain at_start_;
  Domain domain_;
  Stepper stepper_;
};

TEST(FollowedPoint, StrainOfLinearDisplacementsIsExact) {
  MovedLayers layers;
  struct Place {
    double x, y, factor;
  };
  // Within, at the corner of the surface, and on both sides of the interface.
  for (const auto& [x, y, factor] :
       {Place{4.25, -2.25, 1.0}, Place{0.25, -0.25, 1.0}, Place{4.25, -3.75, 1.0}, Place{4.25, -4.25, 3.0}}) {
    EXPECT_NEAR(layers.value(x, y, "exx"), factor * 1e-3, 1e-13) << x << ", " << y;
    EXPECT_NEAR(layers.value(x, y, "eyy"), factor * 4e-3, 1e-13) << x << ", " << y;
    EXPECT_NEAR(layers.value(x, y, "gxy"), factor * 1.5e-3, 1e-13) << x << ", " << y;
  }
}

TEST(FollowedPoint, ParticlesAroundItMayBeCut) {
  MovedLayers layers;
  layers.forget(4.75, -2.25);
  layers.forget(4.75, -1.75);
  EXPECT_NEAR(layers.value(4.25, -2.25, "exx"), 1e-3, 1e-13);
  EXPECT_NEAR(layers.value(4.25, -2.25, "gxy"), 1.5e-3, 1e-13);
}

TEST(FollowedPoint, TooFewParticlesHaveNoStrain) {
  Spec spec = test_support::elastic_box(8.0, 8.0, 1.0);
  spec.soils = {{"soil", spec.soils.front().law}, {"speck", spec.soils.front().law}};
  // The speck is two particles beside each other.
  spec.regions = {{0, {{0.0, -8.0}, {8.0, -8.0}, {8.0, -0.5}, {0.0, -0.5}}},
                  {1, {{4.0, -0.5}, {5.0, -0.5}, {5.0, 0.0}, {4.0, 0.0}}}};
  Domain domain(spec);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  stepper.step();
  const FollowedPoint point(domain, domain.sets, {4.25, -0.25});
  std::vector<double> row;
  point.append_values(Snapshot(domain), stepper, false, row);
  EXPECT_TRUE(std::isnan(row.back()));
}

} // namespace
} // namespace tremolo::mpm_domain
