#include "mpm_domain/particles/fill/fill.hpp"
#include "mpm_domain/particles/fill/rest_stress.hpp"
#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace tremolo::mpm_domain {
namespace {

TEST(Fill, BoxHasItsMassAndParticlesPerCell) {
  Spec spec = test_support::elastic_box(5.0, 3.0, 0.5);
  for (int per_cell = 1; per_cell <= 4; ++per_cell) {
    spec.particles_per_cell = per_cell;
    const std::vector<Particles> sets = fill(spec, std::nullopt);
    EXPECT_EQ(sets.front().size(), 60u * static_cast<std::size_t>(per_cell * per_cell));
    const double mass = std::accumulate(sets.front().mass.begin(), sets.front().mass.end(), 0.0);
    EXPECT_NEAR(mass, 1700.0 * 15.0, 1e-8);
  }
}

TEST(Fill, LaterRegionWins) {
  Spec spec = test_support::elastic_box(4.0, 4.0, 1.0);
  spec.soils.push_back({"lens", materials::LinearElastic{{2000.0, 80e6, 0.3}}});
  spec.regions.push_back({1, {{1.0, -3.0}, {3.0, -3.0}, {3.0, -1.0}, {1.0, -1.0}}});
  const std::vector<Particles> sets = fill(spec, std::nullopt);
  EXPECT_EQ(sets[0].size(), 48u);
  EXPECT_EQ(sets[1].size(), 16u);
}

TEST(Fill, EmptyDomainIsRefused) {
  Spec spec = test_support::elastic_box(4.0, 4.0, 1.0);
  spec.regions.front().polygon = {{10.0, 10.0}, {11.0, 10.0}, {11.0, 11.0}};
  EXPECT_THROW(fill(spec, std::nullopt), std::invalid_argument);
}

TEST(Fill, BoxThatIsNoMultipleOfTheParticleSizeIsRefused) {
  EXPECT_THROW(fill(test_support::elastic_box(4.1, 4.0, 1.0), std::nullopt), std::invalid_argument);
}

TEST(RestStress, IsTheOverburdenOfTheLayersAbove) {
  Spec spec = test_support::elastic_box(2.0, 4.0, 1.0);
  spec.gravity = 10.0;
  spec.soils.push_back({"heavy", materials::LinearElastic{{2000.0, 80e6, 0.2}}});
  spec.regions.push_back({1, {{0.0, -4.0}, {2.0, -4.0}, {2.0, -2.0}, {0.0, -2.0}}});
  std::vector<Particles> sets = fill(spec, std::nullopt);
  set_rest_stress(sets, spec);
  for (std::size_t k = 0; k < sets[1].size(); ++k) {
    const double syy = -(1700.0 * 10.0 * 2.0 + 2000.0 * 10.0 * (-2.0 - sets[1].y[k]));
    EXPECT_NEAR(sets[1].syy[k], syy, 1e-8);
    EXPECT_NEAR(sets[1].sxx[k], 0.25 * syy, 1e-8); // nu/(1-nu) = 0.25
  }
}

} // namespace
} // namespace tremolo::mpm_domain
