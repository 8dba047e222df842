// Level sand that liquefies between its own columns: what its sides give it is what level ground gives its
// neighbours, so that it stays even along x. Sand amplifies the least difference once it has liquefied.

#include "materials/sand/pdmy03/pdmy03.hpp"
#include "materials/sand/pm4sand/pm4sand.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "tests/support/box_models.hpp"
#include "tests/support/own_column.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

constexpr double depth = 8.0; // m
constexpr double cell = 1.0;  // m
constexpr double gravity = 9.81;
const materials::Elasticity rock = {2200.0, 3.2e9, 0.25};

enum class Sand { pm4sand, pdmy03 };

Soil soil_of(Sand sand) {
  const double porosity = sand == Sand::pm4sand ? materials::porosity_of(0.8 - 0.3 * 0.55) : 0.4;
  Soil soil{.name = "sand", .law = materials::pdmy03({.relative_density = 0.57})};
  soil.pores = {.porosity = porosity, .grain_density = 2650.0, .permeability = 1e-4};
  if (sand == Sand::pm4sand) {
    auto law = materials::pm4sand({.density = materials::saturated_density(*soil.pores, {}),
                                   .relative_density = 0.55,
                                   .G_o = 677.0,
                                   .h_po = 0.40});
    law.elastic.at_rest = 0.5;
    soil.law = law;
  }
  soil.damping_time = 0.005 / (std::numbers::pi * 5.0); // 0.5 % at 5 Hz
  return soil;
}

Spec level_sand(Sand sand, double width) {
  Spec spec;
  spec.box = {0.0, -depth, width, 0.0};
  spec.cell_size = cell;
  spec.gravity = gravity;
  spec.water = {0.0, {}};
  spec.soils = {soil_of(sand)};
  spec.regions = {{0, {{0.0, -depth}, {width, -depth}, {width, 0.0}, {0.0, 0.0}}}};
  spec.scheme.dt = 0.5 * 0.65 * cell / 1900.0;
  test_support::add_springs(spec, 1.0, 0.5, {0.5 * width, 0.0});
  return spec;
}

/// Motion of the rock's outcrop at 1 Hz, rising within a second.
IncidentWave shear(double acceleration) {
  return [acceleration](double t) -> eq6::FreeField {
    const double omega = 2.0 * std::numbers::pi;
    const double v = 0.5 * acceleration / omega * std::sin(omega * t) * std::min(1.0, t);
    return {{v, 0.0}, {0.0, 0.0, -rock.density * rock.s_wave_speed() * v}};
  };
}

/// Sums over the cells of a row, from left to right.
struct Row {
  std::vector<double> ratio, settlement;
};

/// Means of all cells, from the base up.
std::vector<Row> rows_of(const Domain& domain) {
  constexpr double per_cell = 0.25;
  const Box& box = domain.spec.box;
  const auto columns = static_cast<std::size_t>(std::lround((box.x_max - box.x_min) / cell));
  std::vector<Row> rows(static_cast<std::size_t>(std::lround(depth / cell)),
                        {std::vector<double>(columns), std::vector<double>(columns)});
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      Row& row = rows[static_cast<std::size_t>((set.y_initial[k] + depth) / cell)];
      const auto i = static_cast<std::size_t>(set.x_initial[k] / cell);
      const double excess = excess_pressure(set, k);
      row.ratio[i] += per_cell * excess / -set.vertical_at_rest[k];
      row.settlement[i] += per_cell * (set.y_initial[k] - set.y[k]);
    }
  return rows;
}

double range(const std::vector<double>& values) {
  return std::ranges::max(values) - std::ranges::min(values);
}

struct Unevenness {
  double ratio = 0.0;      ///< largest difference of r_u in a row
  double settlement = 0.0; ///< largest difference in the uppermost row at the end, over the settlement
  double liquefied = 0.0;  ///< largest r_u
};

/// Shear stress of the uppermost particle in the middle, over its vertical stress, beside that at rest.
void disturb(Domain& domain, double share) {
  const Vector middle{0.5 * (domain.spec.box.x_min + domain.spec.box.x_max), domain.spec.box.y_max};
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      if (std::abs(set.x[k] - middle.x - 0.25 * cell) + std::abs(set.y[k] - middle.y + 0.25 * cell) < 1e-6)
        set.sxy[k] -= share * set.syy[k];
}

/// @param end           s
/// @param disturbance   of one particle, see above
Unevenness shaken(Sand sand, double width, double acceleration, double end, Sides sides = Sides::free_field,
                  double disturbance = 0.0) {
  Spec spec = level_sand(sand, width);
  spec.sides = sides;
  if (spec.periodic())
    spec.springs.clear();
  test_support::FlatGround ground(spec, rock, shear(acceleration));
  disturb(ground.domain, disturbance);
  Unevenness found;
  std::vector<Row> rows;
  while (ground.stepper->time() < end) {
    ground.stepper->step();
    if (ground.stepper->steps() % 50 != 0)
      continue;
    rows = rows_of(ground.domain);
    for (const Row& row : rows) {
      found.ratio = std::max(found.ratio, range(row.ratio));
      found.liquefied = std::max(found.liquefied, std::ranges::max(row.ratio));
    }
  }
  found.settlement = range(rows.back().settlement) / std::ranges::max(rows.back().settlement);
  const EnergyLedger& energy = ground.domain.energy;
  EXPECT_LT(std::abs(energy.residual()), 1e-3 * energy.plastic);
  return found;
}

class LiquefyingSides : public testing::TestWithParam<Sand> {};

/// Until r_u is 0.6. Measured: 2e-5 (PM4Sand), 5e-6 (PDMY03); 0.012 where sides stopped the water.
TEST_P(LiquefyingSides, AreEvenBeforeTheSandLiquefies) {
  const Unevenness found = shaken(GetParam(), 6.0, 0.1 * gravity, 2.5);
  RecordProperty("r_u", std::to_string(found.ratio));
  RecordProperty("settlement", std::to_string(found.settlement));
  EXPECT_GT(found.liquefied, 0.5);
  EXPECT_LT(found.ratio, 5e-4);
  EXPECT_LT(found.settlement, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Sands, LiquefyingSides, testing::Values(Sand::pm4sand, Sand::pdmy03));

struct Shaking {
  Sand sand;
  double acceleration; ///< over g
  double bound;        ///< of the difference of r_u in a row
};

std::ostream& operator<<(std::ostream& out, const Shaking& shaking) {
  return out << (shaking.sand == Sand::pm4sand ? "pm4sand " : "pdmy03 ") << shaking.acceleration << " g";
}

class LiquefiedSides : public testing::TestWithParam<Shaking> {};

/// Eight seconds, in which all but the deepest sand liquefies and, where it strains, dilates. Measured:
/// 0.0002, 0.006 and 0.18. PM4Sand on softer rock (480 m/s) has 0.001 to 0.003. Where it dilates it amplifies
/// what is left at the sides: least at the base, 0.002, and 0.15 within the uppermost metre, which is 0.8
/// kPa.
TEST_P(LiquefiedSides, AreEvenWhileTheSandIsLiquefied) {
  const auto& [sand, acceleration, bound] = GetParam();
  const Unevenness found = shaken(sand, 16.0, acceleration * gravity, 8.0);
  RecordProperty("r_u", std::to_string(found.ratio));
  RecordProperty("settlement", std::to_string(found.settlement));
  EXPECT_GT(found.liquefied, 0.9);
  EXPECT_LT(found.ratio, bound);
}

INSTANTIATE_TEST_SUITE_P(AcceptanceShakings, LiquefiedSides,
                         testing::Values(Shaking{Sand::pdmy03, 0.1, 0.001}, Shaking{Sand::pdmy03, 0.2, 0.01},
                                         Shaking{Sand::pm4sand, 0.2, 0.4}));

/// What the sides leave is what ground makes by itself of a slight unevenness: beside periodic sides, with
/// one particle of 512 whose shear stress is off by 1 % of its vertical stress. Measured: 0.00006 without it,
/// 0.0015 where it is off by 0.1 %, 0.43 by 1 %.
TEST(AcceptanceDisturbedGround, IsAsUnevenAsBesideItsSides) {
  const auto found = [](double disturbance) {
    return shaken(Sand::pm4sand, 16.0, 0.2 * gravity, 8.0, Sides::periodic, disturbance).ratio;
  };
  EXPECT_LT(found(0.0), 3e-4);
  const double disturbed = found(1e-2);
  RecordProperty("r_u", std::to_string(disturbed));
  EXPECT_GT(disturbed, 0.1);
}

} // namespace
} // namespace tremolo::mpm_domain
