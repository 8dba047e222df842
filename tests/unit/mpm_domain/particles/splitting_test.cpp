// Particles that enter finer cells: nothing that the grid or the sums see may change when they are cut.

#include "mpm_domain/particles/splitting.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/unit/mpm_domain/graded/levels_in_x.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

namespace tremolo::mpm_domain {
namespace {

using namespace test;

struct Case {
  Transfer transfer;
  ParticleBoxes boxes;
  const char* name;
};

constexpr std::array schemes{Case{Transfer::apic, ParticleBoxes::fixed, "Apic"},
                             Case{Transfer::flip, ParticleBoxes::fixed, "Flip"},
                             Case{Transfer::apic, ParticleBoxes::deforming, "ApicOwnBoxes"}};

class Splitting : public testing::TestWithParam<Case> {
protected:
  static Spec levels_in_x() {
    Spec spec = test::levels_in_x(GetParam().transfer);
    spec.boxes = GetParam().boxes;
    return spec;
  }
};

/// S and G of the four, a quarter each, are those of the one: to the grid nothing has happened.
TEST_P(Splitting, LeavesTheGridAsItIs) {
  Domain domain(levels_in_x());
  disturb(domain);
  shift(domain, 5.3); // across the first interface
  expect_grid_as_it_was(domain, [](Domain& d) { ASSERT_GT(split_particles(d), 0U); });
}

TEST_P(Splitting, KeepsMassVolumeMomentumAndSpin) {
  Domain domain(levels_in_x());
  disturb(domain);
  shift(domain, 5.3);
  const Conserved before = conserved_by(domain);
  const std::size_t cut = split_particles(domain);
  ASSERT_GT(cut, 0U);
  const Conserved after = conserved_by(domain);
  EXPECT_NEAR(after.mass, before.mass, 1e-14 * before.mass);
  EXPECT_NEAR(after.volume, before.volume, 1e-14 * before.volume);
  EXPECT_NEAR(after.px, before.px, 1e-14 * before.mass);
  EXPECT_NEAR(after.py, before.py, 1e-14 * before.mass);
  EXPECT_NEAR(after.spin, before.spin, 1e-13 * before.mass * 10.0);
  if (GetParam().transfer == Transfer::flip) {
    EXPECT_NEAR(after.kinetic, before.kinetic, 1e-14 * before.mass);
  }
}

TEST_P(Splitting, HandsStressStateAndDisplacementDown) {
  Spec spec = levels_in_x();
  spec.soils = {{"clay", materials::MohrCoulomb{.elastic = {1700.0, 40e6, 0.28},
                                                .cohesion_peak = 4e3,
                                                .friction_peak = 0.5,
                                                .friction_residual = 0.4,
                                                .softening = 10.0}}};
  Domain domain(spec);
  disturb(domain);
  shift(domain, 5.3);
  Particles& coarse = domain.sets[0];
  for (std::size_t k = 0; k < coarse.size(); ++k)
    for (std::size_t s = 0; s < coarse.state_size; ++s)
      coarse.state[k * coarse.state_size + s] = coarse.sxx[k] + static_cast<double>(s);
  const std::size_t before = coarse.size();
  const std::size_t cut = split_particles(domain);
  sort_particles(domain);
  const Particles& fine = domain.sets[1];
  EXPECT_EQ(coarse.size(), before - cut);
  EXPECT_EQ(fine.size(), 4 * cut);
  for (const Particles* set : {static_cast<const Particles*>(&coarse), &fine}) {
    ASSERT_EQ(set->state.size(), set->size() * set->state_size);
    for (std::size_t k = 0; k < set->size(); ++k) {
      EXPECT_EQ(set->index_of[set->id[k]], k);
      EXPECT_NEAR(set->x[k] - set->x_initial[k], 5.3, 1e-12);
      for (std::size_t s = 0; s < set->state_size; ++s)
        EXPECT_EQ(set->state[k * set->state_size + s], set->sxx[k] + static_cast<double>(s));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Transfers, Splitting, testing::ValuesIn(schemes),
                         [](const auto& of) { return of.param.name; });

/// Only those wholly inside, and only where cells would run short of particles.
TEST(SplittingRule, CutsWhatLiesInFinerCellsAndIsTooWideForThem) {
  for (int per_cell = 1; per_cell <= 4; ++per_cell) {
    Domain domain(levels_in_x(Transfer::apic, per_cell));
    disturb(domain);
    shift(domain, 3.6); // from 4.6 m to 7.6 m: the interface at 6 m goes through
    const double size = 2.0 * domain.sets[0].half_size;
    std::size_t inside = 0;
    for (const double x : domain.sets[0].x)
      inside += x - 0.5 * size > 6.0 - 1e-9 ? 1 : 0;
    EXPECT_EQ(split_particles(domain), per_cell <= 2 ? inside : 0U) << per_cell;
    EXPECT_EQ(split_particles(domain), 0U);
  }
}

TEST(SplittingRule, CutsTwiceWhatHasPassedTwoLevels) {
  Domain domain(levels_in_x(Transfer::flip));
  const std::size_t before = domain.particle_count();
  disturb(domain);
  shift(domain, 8.05 - 0.05); // from 9 m to 12 m
  split_particles(domain);
  EXPECT_EQ(domain.sets[0].size(), 0U);
  EXPECT_EQ(domain.sets[2].size(), 16U * before);
}

/// Faces and monitors ride on particles, which therefore stay.
TEST(SplittingRule, LeavesParticlesWholeThatSomethingRidesOn) {
  Domain domain(levels_in_x(Transfer::apic));
  keep_whole(domain, 0, 17);
  keep_whole(domain, 0, 5);
  keep_whole(domain, 0, 17);
  disturb(domain);
  shift(domain, 5.9);
  split_particles(domain);
  const Particles& set = domain.sets[0];
  EXPECT_NE(set.index_of[5], Particles::nowhere);
  EXPECT_NE(set.index_of[17], Particles::nowhere);
  EXPECT_EQ(set.whole.size(), 2U);

  Spec with_faces = levels_in_x(Transfer::apic);
  with_faces.regions = {{0, {{0.0, -8.0}, {4.0, -8.0}, {4.0, 0.0}, {0.0, 0.0}}}};
  Domain other(with_faces);
  disturb(other);
  shift(other, 6.1);
  split_particles(other);
  ASSERT_FALSE(other.boundary.faces().empty());
  for (const BoundaryFace& face : other.boundary.faces())
    EXPECT_NE(other.sets[face.set].index_of[face.id], Particles::nowhere);
}

/// A block that flies through all levels: cut on the way, moving as one.
TEST(SplittingOnTheWay, ABlockKeepsItsMotionThroughAllLevels) {
  for (const Case& scheme : schemes) {
    Spec spec = levels_in_x(scheme.transfer);
    spec.boxes = scheme.boxes;
    Domain domain(spec);
    for (double& v : domain.sets[0].vx)
      v = 20.0;
    const Conserved before = conserved_by(domain);
    const std::size_t count = domain.particle_count();
    Stepper stepper(domain, 0.0, test_support::no_traction(domain));
    while (stepper.time() < 0.42)
      stepper.step();
    EXPECT_EQ(domain.particle_count(), domain.sets[2].size()); // 9.4 m and more: all on the finest level
    EXPECT_EQ(domain.particle_count(), 16U * count);
    const Conserved after = conserved_by(domain);
    EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
    EXPECT_NEAR(after.px, before.px, 1e-12 * before.px);
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        EXPECT_NEAR(set.x[k] - set.x_initial[k], 20.0 * stepper.time(), 1e-10);
        EXPECT_NEAR(set.sxx[k], 0.0, 1e-3); // Pa, of 40 MPa soil
      }
  }
}

/// A grid that must grow keeps its levels where they are.
TEST(GradedGrowth, ABlockThatFliesOutOfTheGridTakesItAlong) {
  Spec spec = levels_in_x(Transfer::apic);
  spec.refine.push_back({{1.0, -5.0, 5.0, 0.0}, 1}); // reaches the surface, so it has no end above
  Domain domain(spec);
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      set.vy[k] = 30.0;
  const Conserved before = conserved_by(domain);
  const int rows = domain.grid.ny;
  Stepper stepper(domain, 0.0, test_support::no_traction(domain));
  while (stepper.time() < 0.5)
    stepper.step();
  EXPECT_GT(domain.grid.ny, rows);
  EXPECT_EQ(domain.mesh->tree().finest_in({2.0, 10.0, 4.0, 11.0}), 1);
  EXPECT_EQ(domain.mesh->tree().finest_in({6.5, -5.0, 7.0, -4.0}), 1);
  EXPECT_EQ(domain.mesh->tree().finest_in({9.5, -5.0, 10.0, -4.0}), 2);
  const Conserved after = conserved_by(domain);
  EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
  EXPECT_NEAR(after.py, before.py, 1e-12 * before.py);
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      EXPECT_NEAR(set.y[k] - set.y_initial[k], 30.0 * stepper.time(), 1e-10);
      EXPECT_NEAR(set.syy[k], 0.0, 1e-3);
    }
}

} // namespace
} // namespace tremolo::mpm_domain
