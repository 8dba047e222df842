// A column of the domain's own, one cell wide and periodic, on a rigid base, with PDMY03 and PM4Sand against
// u-p finite elements with the same laws, and against the two-phase column (freefield/twophase). Cells are as
// high as the elements of the reference. What is asked of PM4Sand is what the reference says is determined:
// what happens before liquefaction, and means over it.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/hard_case.hpp"
#include "tests/support/liquefaction_reference.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using namespace freefield::testing;

constexpr double cell = 0.5;    // m
constexpr double height = 10.0; // m
constexpr double gravity = 9.81;

Spec column_of(const LiquefyingSand& sand) {
  Spec spec;
  spec.box = {0.0, -height, cell, 0.0};
  spec.cell_size = cell;
  spec.gravity = gravity;
  spec.sides = Sides::periodic;
  spec.water = {0.0, {}};
  double top = 0.0;
  for (const freefield::Layer& layer : liquefying_profile(sand).layers) {
    const double bottom = top - layer.thickness;
    spec.regions.push_back({spec.soils.size(), {{0.0, bottom}, {cell, bottom}, {cell, top}, {0.0, top}}});
    Soil& soil = spec.soils.emplace_back(
        Soil{.name = fmt::format("sand {}", spec.soils.size() + 1), .law = *layer.law});
    soil.pores = layer.pores;
    soil.damping_time = 0.005 / (std::numbers::pi * 5.0); // 0.5 % at 5 Hz
    top = bottom;
  }
  return spec;
}

/// Excess pore pressure of the cells from the surface down, over the hydrostatic one where they are now, Pa.
std::vector<double> excess_of_cells(const Domain& domain) {
  std::vector<double> sums(static_cast<std::size_t>(height / cell));
  std::vector<int> counts(sums.size());
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k) {
      const auto row = static_cast<std::size_t>(-set.y_initial[k] / cell);
      sums[row] += excess_pressure(set, k);
      ++counts[row];
    }
  for (std::size_t row = 0; row < sums.size(); ++row)
    sums[row] /= counts[row];
  return sums;
}

/// Linear between the centres of cells, zero at the surface.
double at_depth(const std::vector<double>& cells, double depth) {
  const double position = depth / cell - 0.5;
  if (position < 0.0)
    return cells.front() * depth / (0.5 * cell);
  const auto above = std::min(static_cast<std::size_t>(position), cells.size() - 2);
  return std::lerp(cells[above], cells[above + 1], position - static_cast<double>(above));
}

double settlement_of(const Domain& domain) {
  double top = -height;
  double settlement = 0.0;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      if (set.y_initial[k] > top) {
        top = set.y_initial[k];
        settlement = set.y_initial[k] - set.y[k];
      }
  return settlement;
}

/// The domain's column; its ledger is checked at the end.
LiquefactionHistory shaken(const LiquefyingSand& sand) {
  Domain domain(column_of(sand));
  replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
  constexpr double rigid = 1e3; // times the ground
  for (BoundaryFace& face : domain.boundary.faces()) {
    face.ground.impedance_p *= rigid;
    face.ground.impedance_s *= rigid;
  }
  const BaseShaking shaking(sand.shaking);
  Stepper stepper(domain, 0.0, [&](long, double t, auto, auto field) {
    std::ranges::fill(field, eq6::FreeField{{shaking(t).x, 0.0}, {}});
  });
  const double weight = materials::buoyant_density(*domain.spec.soils.front().pores, {}) * gravity;
  LiquefactionHistory history;
  const long rows = std::lround(sand.end / 0.02);
  for (long row = 0; row <= rows; ++row) {
    const double time = 0.02 * static_cast<double>(row);
    while (stepper.time() < time - 0.5 * stepper.dt())
      stepper.step();
    const std::vector<double> cells = excess_of_cells(domain);
    history.time.push_back(time);
    history.settlement.push_back(settlement_of(domain));
    for (std::size_t i = 0; i < depths.size(); ++i)
      history.ratio[i].push_back(at_depth(cells, depths[i]) / (weight * depths[i]));
  }
  const EnergyLedger& energy = domain.energy;
  EXPECT_LT(std::abs(energy.residual()), 1e-3 * energy.plastic);
  EXPECT_GT(energy.drag, 0.0);
  return history;
}

/// Shaken until 15 s, when all but the deepest soil has liquefied, or to the end of the shaking.
class LiquefyingPdmy03 : public ::testing::TestWithParam<double> {};

TEST_P(LiquefyingPdmy03, IsThatOfTheReference) {
  const auto reference = stored("C2");
  SKIP_WITHOUT(reference, "C2");
  LiquefyingSand sand = pdmy03_column("C2");
  sand.end = GetParam();
  const auto ours = shaken(sand);
  const auto fe = computed(sand);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    SCOPED_TRACE(depths[i]);
    for (const double level : {0.5, 0.7}) {
      EXPECT_NEAR(ours.time_of(i, level), reference.time_of(i, level), 0.1) << level;
      EXPECT_NEAR(ours.time_of(i, level), fe.time_of(i, level), 0.1) << level;
    }
    auto band = bands("C2", depths[i]);
    expect_within(ours.time_of(i, 0.8), band["t80_1s"], 0.1, "t80");
    expect_within(ours.time_of(i, 0.9), band["t90_1s"], 0.15, "t90");
    EXPECT_NEAR(ours.mean(i, 5.0, 15.0), reference.mean(i, 5.0, 15.0), 0.005);
    EXPECT_NEAR(ours.mean(i, 5.0, 15.0), fe.mean(i, 5.0, 15.0), 0.005);
  }
  for (const double time : {15.0, sand.end}) {
    EXPECT_NEAR(ours.settlement_at(time) / reference.settlement_at(time), 1.0, 0.01) << time;
    EXPECT_NEAR(ours.settlement_at(time) / fe.settlement_at(time), 1.0, 0.01) << time;
  }
  // Both columns are nearer to each other than either is to the reference.
  const double to_reference = std::min(apart(ours, reference, sand.end), apart(fe, reference, sand.end));
  test_support::bounded("r_u, root mean square, to finite elements over that to the reference",
                        apart(ours, fe, sand.end) / to_reference, 1.0);
}

std::string seconds(const ::testing::TestParamInfo<double>& end) {
  return "until" + std::to_string(std::lround(end.param)) + "s";
}

INSTANTIATE_TEST_SUITE_P(Shaken, LiquefyingPdmy03, ::testing::Values(15.0), seconds);
INSTANTIATE_TEST_SUITE_P(AcceptanceShaken, LiquefyingPdmy03, ::testing::Values(25.0), seconds);

struct Sand {
  const char* run;
  double relative_density, G_o, h_po;
  double end; ///< s

  friend void PrintTo(const Sand& sand, std::ostream* out) {
    *out << sand.run << " until " << sand.end << " s";
  }
};

class LiquefyingPm4Sand : public ::testing::TestWithParam<Sand> {};

TEST_P(LiquefyingPm4Sand, IsThatOfTheReference) {
  const auto& [run, density, G_o, h_po, end] = GetParam();
  const auto reference = stored(run);
  SKIP_WITHOUT(reference, run);
  const auto ours = shaken(pm4sand_column(run, density, G_o, h_po, 1e-4, end));
  for (std::size_t i = 0; i < depths.size(); ++i) {
    SCOPED_TRACE(depths[i]);
    auto band = bands(run, depths[i]);
    if (depths[i] > 9.0) { // the reference's own runs differ by seconds, and by 0.05 in this mean
      // B1 misses it by 0.05: 0.872 to 0.877 with steps of 0.5 and 0.8 of the critical one and a D_R 0.2 % up
      // and down; our finite elements have 0.887 to 0.976 with such changes, and 0.887 with a step of 0.2 ms.
      expect_within(ours.mean(i, 5.0, 15.0), band["ru_mean_5_15"], 0.03, "mean r_u from 5 to 15 s");
      continue;
    }
    if (depths[i] < 2.0) { // the reference's README: 0.05, and no time
      expect_within(ours.mean(i, 5.0, 15.0), band["ru_mean_5_15"], 0.05, "mean r_u from 5 to 15 s");
      continue;
    }
    expect_within(ours.mean(i, 5.0, 15.0), band["ru_mean_5_15"], 0.02, "mean r_u from 5 to 15 s");
    expect_within(ours.time_of(i, 0.5), band["t50_1s"], 0.1, "t50");
    expect_within(ours.time_of(i, 0.7), band["t70_1s"], 0.2, "t70");
    EXPECT_NEAR(ours.time_of(i, 0.5), reference.time_of(i, 0.5), 0.1);
  }
  // The reference's own run of B2 settles by 0.09 mm more than the median of its variants: their range
  // counts.
  auto column = bands(run, std::nullopt);
  for (const auto& [name, time] : {std::pair("settle_15s_mm", 15.0), {"settle_end_shake_mm", 25.0}})
    if (time <= end)
      expect_within(1e3 * ours.settlement_at(time), column[name], 0.02 * column[name].high, name);
}

INSTANTIATE_TEST_SUITE_P(Sands, LiquefyingPm4Sand, ::testing::Values(Sand{"B2", 0.55, 677.0, 0.40, 15.0}));
INSTANTIATE_TEST_SUITE_P(AcceptanceSands, LiquefyingPm4Sand,
                         ::testing::Values(Sand{"B1", 0.35, 476.0, 0.53, 25.0},
                                           Sand{"B2", 0.55, 677.0, 0.40, 25.0}));

/// Dense sand at 0.2 g, whose damping has to follow the stiffness that fabric and stress ratio leave: the
/// reference's variants settle by 11.1 to 12.1 mm (README there, run B6).
TEST(LiquefyingColumn, AcceptanceSettlesAt02gAsTheReferenceWithItsDamping) {
  LiquefyingSand sand = pm4sand_column("B6", 0.75, 890.0, 0.63, 1e-3);
  sand.shaking = 1.962;
  expect_within(1e3 * shaken(sand).settlement_at(25.0), {11.1, 12.1}, 0.02 * 12.1, "settlement");
}

/// Ten times as permeable, until nearly all excess pressure is gone: settlement to 5 %, r_u while water
/// leaves to 0.02.
TEST(LiquefyingColumn, AcceptanceDrainsAfterShakingLikeTheReference) {
  const auto reference = stored("B3E");
  SKIP_WITHOUT(reference, "B3E");
  const auto ours = shaken(pm4sand_column("B3E", 0.55, 677.0, 0.40, 1e-3, 60.0));
  for (const double time : {25.0, 30.0, 40.0, 60.0})
    for (std::size_t i = 0; i < depths.size(); ++i)
      EXPECT_NEAR(ours.ratio_at(i, time), reference.ratio_at(i, time), 0.02) << depths[i] << " m, " << time;
  for (std::size_t i = 1; i <= 3; ++i) {
    EXPECT_NEAR(ours.time_of(i, 0.5), reference.time_of(i, 0.5), 0.1) << depths[i];
    EXPECT_NEAR(ours.time_of(i, 0.7), reference.time_of(i, 0.7), 0.2) << depths[i];
  }
  for (const double time : {15.0, 25.0, 60.0})
    EXPECT_NEAR(ours.settlement_at(time) / reference.settlement_at(time), 1.0, 0.05) << time;
}

} // namespace
} // namespace tremolo::mpm_domain
