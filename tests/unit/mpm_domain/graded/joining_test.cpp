// Particles that leave finer cells: what they were before they were cut, they are again.

#include "mpm_domain/particles/joining.hpp"
#include "mpm_domain/particles/splitting.hpp"
#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/affine_velocity.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/unit/mpm_domain/graded/levels_in_x.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

namespace tremolo::mpm_domain {
namespace {

using namespace test;

constexpr materials::MohrCoulomb clay{.elastic = {1700.0, 40e6, 0.28},
                                      .cohesion_peak = 4e3,
                                      .friction_peak = 0.5,
                                      .friction_residual = 0.4,
                                      .softening = 10.0};

/// 36 squares of 0.5 m that are four particles each, in half-metre cells.
Spec fine_block(Transfer transfer) {
  Spec spec = levels_in_x(transfer);
  spec.soils = {{"clay", clay}};
  spec.regions = {{0, {{6.0, -6.0}, {9.0, -6.0}, {9.0, -3.0}, {6.0, -3.0}}}};
  return spec;
}

constexpr double into_coarse_cells = -4.9;

/// By the square that they filled at the start.
std::map<std::pair<long, long>, std::vector<std::size_t>> quartets(const Particles& fine) {
  std::map<std::pair<long, long>, std::vector<std::size_t>> all;
  for (std::size_t k = 0; k < fine.size(); ++k)
    all[{std::lround(std::floor(2.0 * fine.x_initial[k])), std::lround(std::floor(2.0 * fine.y_initial[k]))}]
        .push_back(k);
  return all;
}

Vector mean(const std::vector<std::size_t>& of, const std::vector<double>& x, const std::vector<double>& y) {
  Vector sum;
  for (const std::size_t k : of)
    sum = {sum.x + x[k], sum.y + y[k]};
  return {sum.x / 4.0, sum.y / 4.0};
}

/// One random stress and, if wanted, one random linear velocity for each four.
void disturb_by_quartets(Domain& domain, bool velocities) {
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  Particles& p = domain.sets[1];
  const bool affine = !p.bxx.empty();
  for (const auto& [square, four] : quartets(p)) {
    for (std::vector<double>* column : {&p.sxx, &p.syy, &p.szz, &p.sxy}) {
      const double value = any(random);
      for (const std::size_t k : four)
        (*column)[k] = value;
    }
    const Vector v{any(random), any(random)};
    const test_support::AffineVelocity c =
        affine ? test_support::AffineVelocity{any(random), any(random), any(random), any(random)}
               : test_support::AffineVelocity{};
    const Vector centre = mean(four, p.x, p.y);
    for (const std::size_t k : four) {
      if (!velocities)
        continue;
      const double dx = p.x[k] - centre.x;
      const double dy = p.y[k] - centre.y;
      p.vx[k] = v.x + c.xx * dx + c.xy * dy;
      p.vy[k] = v.y + c.yx * dx + c.yy * dy;
      if (affine)
        test_support::set_affine_velocity(domain, p, k, c);
    }
  }
}

class Joining : public testing::TestWithParam<Transfer> {};

/// Four that move as one would: to the grid nothing has happened.
TEST_P(Joining, LeavesTheGridAsItIs) {
  Domain domain(fine_block(GetParam()));
  shift(domain, into_coarse_cells);
  disturb_by_quartets(domain, true);
  expect_grid_as_it_was(domain, [](Domain& d) { ASSERT_EQ(join_particles(d), 36U); });
}

/// Whatever the four do.
TEST_P(Joining, KeepsMassVolumeMomentumAndSpin) {
  Domain domain(fine_block(GetParam()));
  shift(domain, into_coarse_cells);
  disturb(domain);
  disturb_by_quartets(domain, false);
  const Sums before = sums_of(domain);
  const Particles& fine = domain.sets[1];
  double within = 0.0; // kinetic energy of the four about their mean
  for (const auto& [square, four] : quartets(fine)) {
    const Vector v = mean(four, fine.vx, fine.vy);
    for (const std::size_t k : four)
      within += 0.5 * fine.mass[k] * (std::pow(fine.vx[k] - v.x, 2) + std::pow(fine.vy[k] - v.y, 2));
  }
  ASSERT_EQ(join_particles(domain), 36U);
  const Sums after = sums_of(domain);
  EXPECT_NEAR(after.mass, before.mass, 1e-14 * before.mass);
  EXPECT_NEAR(after.volume, before.volume, 1e-14 * before.volume);
  EXPECT_NEAR(after.px, before.px, 1e-14 * before.mass);
  EXPECT_NEAR(after.py, before.py, 1e-14 * before.mass);
  if (GetParam() == Transfer::apic) {
    EXPECT_NEAR(after.spin, before.spin, 1e-13 * before.mass * 10.0);
  }
  EXPECT_GT(within, 0.1 * before.kinetic);
  EXPECT_NEAR(after.kinetic, before.kinetic - within, 1e-13 * before.kinetic);
}

/// Cut in fine cells, joined in coarse ones.
TEST_P(Joining, GivesBackWhatWasCut) {
  const auto by_place = [](Particles& p) {
    std::map<std::pair<long, long>, std::vector<double>> all;
    for (std::size_t k = 0; k < p.size(); ++k)
      for (const std::vector<double>* column : p.columns())
        all[{std::lround(100.0 * p.x_initial[k]), std::lround(100.0 * p.y_initial[k])}].push_back(
            (*column)[k]);
    return all;
  };
  Spec spec = levels_in_x(GetParam());
  spec.soils = {{"clay", clay}};
  Domain domain(spec);
  disturb(domain);
  const auto before = by_place(domain.sets[0]);
  shift(domain, 5.3);
  const std::size_t cut = split_particles(domain);
  ASSERT_GT(cut, 0U);
  EXPECT_EQ(join_particles(domain), 0U); // where they are they belong
  shift(domain, -5.3);
  EXPECT_EQ(join_particles(domain), cut);
  EXPECT_EQ(domain.sets[1].size(), 0U);
  const auto after = by_place(domain.sets[0]);
  ASSERT_EQ(after.size(), before.size());
  for (const auto& [place, values] : before)
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(after.at(place)[i], values[i], 1e-14 * (1.0 + std::abs(values[i]))) << i;
  sort_particles(domain);
  const Particles& set = domain.sets[0];
  for (std::size_t k = 0; k < set.size(); ++k)
    EXPECT_EQ(set.index_of[set.id[k]], k);
}

/// Boxes that have followed the soil are cut and given back with their moments.
TEST(JoiningBoxes, GiveBackWhatWasCut) {
  Spec spec = levels_in_x(Transfer::apic);
  spec.soils = {{"clay", clay}};
  spec.boxes = ParticleBoxes::deforming;
  Domain domain(spec);
  Particles& p = domain.sets[0];
  const double square = p.half_size * p.half_size;
  p.box_xx.assign(p.size(), 1.2 * square);
  p.box_xy.assign(p.size(), 0.1 * square);
  p.box_yy.assign(p.size(), 0.9 * square);
  shift(domain, 5.3);
  const std::size_t cut = split_particles(domain);
  ASSERT_GT(cut, 0U);
  for (const double moment : domain.sets[1].box_xx)
    EXPECT_NEAR(moment, 0.3 * square, 1e-15);
  shift(domain, -5.3);
  EXPECT_EQ(join_particles(domain), cut);
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_NEAR(p.box_xx[k], 1.2 * square, 1e-14);
    EXPECT_NEAR(p.box_yy[k], 0.9 * square, 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Transfers, Joining, testing::Values(Transfer::apic, Transfer::flip),
                         [](const auto& of) { return of.param == Transfer::apic ? "Apic" : "Flip"; });

/// A reason not to join four particles, given to one of them.
using Reason = std::function<void(Domain&, std::size_t)>;

std::size_t joined_with(const Reason& reason) {
  Domain domain(fine_block(Transfer::apic));
  shift(domain, into_coarse_cells);
  disturb_by_quartets(domain, true);
  reason(domain, quartets(domain.sets[1]).begin()->second[2]);
  return join_particles(domain);
}

TEST(JoiningRule, LeavesAloneWhatIsNotAlike) {
  EXPECT_EQ(joined_with([](Domain&, std::size_t) {}), 36U);
  EXPECT_EQ(joined_with([](Domain& d, std::size_t k) { d.sets[1].state[k] = 1e-9; }), 35U); // has yielded
  EXPECT_EQ(joined_with([](Domain& d, std::size_t k) {
              Particles& p = d.sets[1];
              for (std::vector<double>* s : {&p.sxx, &p.syy, &p.szz, &p.sxy})
                (*s)[k] *= 1.08; // 6 % more than the mean
            }),
            35U);
  EXPECT_EQ(joined_with([](Domain& d, std::size_t k) {
              Particles& p = d.sets[1];
              for (std::vector<double>* s : {&p.sxx, &p.syy, &p.szz, &p.sxy})
                (*s)[k] *= 1.06;
            }),
            36U);
  EXPECT_EQ(joined_with([](Domain& d, std::size_t k) { keep_whole(d, 1, d.sets[1].id[k]); }), 35U);
  EXPECT_EQ(joined_with([](Domain& d, std::size_t k) { d.sets[1].y[k] += 0.3 * 0.125; }), 35U);
  EXPECT_EQ(joined_with([](Domain& d, std::size_t k) { d.sets[1].y[k] += 0.2 * 0.125; }), 36U);
  EXPECT_EQ(joined_with([](Domain& d, std::size_t k) { d.sets[1].x[k] += 6.0; }), 35U); // in fine cells
}

/// Two of the four in one place, another place empty.
TEST(JoiningRule, TheFourFillTheirSquare) {
  EXPECT_EQ(joined_with([](Domain& d, std::size_t k) {
              Particles& p = d.sets[1];
              const std::size_t other = quartets(p).begin()->second[0];
              ASSERT_NE(other, k);
              p.x[k] = p.x[other];
              p.y[k] = p.y[other];
            }),
            35U);
}

/// Of soil without stress, what there is of it is rounding.
TEST(JoiningRule, StressThatIsRoundingMayDiffer) {
  for (const double pascal : {1e-3, 1.0}) {
    Domain domain(fine_block(Transfer::apic));
    shift(domain, into_coarse_cells);
    disturb(domain);
    for (std::vector<double>* s :
         {&domain.sets[1].sxx, &domain.sets[1].syy, &domain.sets[1].szz, &domain.sets[1].sxy})
      for (double& value : *s)
        value *= pascal;
    EXPECT_EQ(join_particles(domain), pascal < 0.1 ? 36U : 0U);
  }
}

/// Only what lies in coarser cells with all of its new box; and what is joined there is not cut again.
TEST(JoiningRule, JoinsWhatLiesInCoarserCells) {
  Domain domain(fine_block(Transfer::apic));
  shift(domain, -1.4); // squares of 0.5 m from 4.6 m on, cells are fine from 6 m on
  EXPECT_EQ(join_particles(domain), 2U * 6U);
  EXPECT_EQ(join_particles(domain), 0U);
  EXPECT_EQ(split_particles(domain), 0U);
}

TEST(JoiningRule, JoinsTwiceWhatHasPassedTwoLevels) {
  Spec spec = fine_block(Transfer::flip);
  spec.regions = {{0, {{9.0, -6.0}, {12.0, -6.0}, {12.0, -3.0}, {9.0, -3.0}}}};
  Domain domain(spec);
  for (Particles& p : domain.sets)
    p.whole.clear(); // of faces at the right side
  ASSERT_EQ(domain.particle_count(), 16U * 36U);
  shift(domain, -7.8);
  EXPECT_EQ(join_particles(domain), 4U * 36U + 36U);
  EXPECT_EQ(domain.sets[0].size(), 36U);
}

TEST(JoiningRule, NeedsLevels) {
  Spec spec = test_support::elastic_box(4.0, 4.0, 1.0);
  spec.join_particles = true;
  EXPECT_THROW(Domain{spec}, std::invalid_argument);
}

Spec flight(Transfer transfer, bool subcycle) {
  Spec spec = levels_in_x(transfer);
  spec.regions = {{0, {{2.0, -5.0}, {4.0, -5.0}, {4.0, -4.0}, {2.0, -4.0}}}};
  spec.join_particles = true;
  spec.scheme.subcycle = subcycle;
  return spec;
}

/// A block that flies through all levels and back, twice.
void fly_there_and_back(Transfer transfer, bool subcycle) {
  Domain domain(flight(transfer, subcycle));
  for (double& v : domain.sets[0].vx)
    v = 40.0;
  const Sums before = sums_of(domain);
  const std::size_t count = domain.particle_count();
  Stepper stepper(domain, 0.0, test_support::no_traction());
  for (int round = 0; round < 2; ++round)
    for (const bool there : {true, false}) {
      while (std::ranges::any_of(domain.sets, [&](const Particles& p) {
        return std::ranges::any_of(p.x, [&](double x) { return there ? x < 9.3 : x > 4.5; });
      }))
        stepper.step();
      EXPECT_EQ(domain.particle_count(), there ? 16U * count : count);
      EXPECT_EQ(domain.particle_count(), domain.sets[there ? 2 : 0].size());
      const Sums sums = sums_of(domain);
      EXPECT_NEAR(sums.mass, before.mass, 1e-13 * before.mass);
      EXPECT_NEAR(sums.px, there ? before.px : -before.px, 1e-12 * before.px);
      for (Particles& set : domain.sets)
        for (std::size_t k = 0; k < set.size(); ++k) {
          EXPECT_NEAR(set.x[k] - set.x_initial[k],
                      domain.sets[there ? 2 : 0].x[0] - domain.sets[there ? 2 : 0].x_initial[0], 1e-10);
          EXPECT_NEAR(set.sxx[k], 0.0, 1e-3); // Pa, of 40 MPa soil
        }
      for (Particles& set : domain.sets)
        for (double& v : set.vx)
          v = -v;
    }
}

TEST(JoiningOnTheWay, ABlockThatComesAndGoesKeepsItsNumberOfParticles) {
  for (const Transfer transfer : {Transfer::apic, Transfer::flip})
    for (const bool subcycle : {false, true})
      fly_there_and_back(transfer, subcycle);
}

Spec elastic_fine_block(Transfer transfer) {
  Spec spec = fine_block(transfer);
  spec.soils = levels_in_x(transfer).soils;
  return spec;
}

/// A stretching vibration along a block that was filled in fine cells and flies out of them.
void set_vibrating(Domain& domain) {
  for (Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      p.vx[k] = -20.0 + 0.3 * std::cos(std::numbers::pi * (p.x[k] - 6.0) / 3.0);
}

TEST(JoiningOnTheWay, TheNumberOfThreadsDoesNotMatter) {
  std::map<int, std::vector<double>> places;
  for (const int threads : {1, 2}) {
    Spec spec = elastic_fine_block(Transfer::apic);
    spec.join_particles = true;
    spec.threads = threads;
    Domain domain(spec);
    set_vibrating(domain);
    const std::size_t count = domain.particle_count();
    Stepper stepper(domain, 0.0, test_support::no_traction());
    while (stepper.time() < 0.2)
      stepper.step();
    EXPECT_LT(domain.particle_count(), count);
    for (const Particles& p : domain.sets)
      places[threads].insert(places[threads].end(), p.x.begin(), p.x.end());
  }
  EXPECT_EQ(places[1], places[2]);
}

/// The kinetic energy of the grid with and without: what the transfer is told of, and nobody else.
TEST(JoiningOnTheWay, WhatItTakesOfTheEnergyIsBookedAsTransfer) {
  const auto kinetic = [](Domain& domain) {
    sort_particles(domain);
    scatter(domain, ScatterPart::both);
    return grid_velocities(domain);
  };
  Spec spec = elastic_fine_block(Transfer::flip);
  spec.scheme.order = StepOrder::usl; // whose transfer is booked in one place
  Domain whole(spec);
  Domain again(spec);
  spec.join_particles = true;
  Domain joined(spec);
  for (Domain* domain : {&whole, &again, &joined})
    set_vibrating(*domain);
  Stepper of_whole(whole, 0.0, test_support::no_traction());
  Stepper of_again(again, 0.0, test_support::no_traction());
  Stepper of_joined(joined, 0.0, test_support::no_traction());
  while (joined.particle_count() == again.particle_count()) {
    if (of_joined.steps() > 0)
      of_again.step();
    of_joined.step();
    ASSERT_LT(of_joined.time(), 0.5);
  }
  while (of_whole.steps() < of_joined.steps())
    of_whole.step();
  ASSERT_EQ(of_again.steps() + 1, of_joined.steps());
  const double before = kinetic(again);
  ASSERT_GT(join_particles(again), 0U);
  const double loss = kinetic(again) - before;
  EXPECT_LT(loss, 0.0);
  EXPECT_NEAR(joined.energy.transfer - whole.energy.transfer, loss, 1e-12 * before);
  EXPECT_GT(std::abs(loss), 1e4 * 1e-12 * before) << "too small to be told";
}

} // namespace
} // namespace tremolo::mpm_domain
