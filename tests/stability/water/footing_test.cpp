// An undrained footing: clay of undrained strength c under the table, whose pores hold water a hundred times
// as stiff as its skeleton. It carries (2 + pi) c as dry clay does; a scheme that locks carries more and
// more, and pressures that are not filtered jump from cell to cell.

#include "tests/support/growing_load.hpp"
#include "wet_scenes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <utility>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double cohesion = 20e3;    // c, Pa
constexpr double width = 4.0;        // B of the footing, m
constexpr double cell = 0.25;        // m
constexpr double left = 1.5 * width; // where it begins, m
constexpr double block = 0.75;       // height of the footing, m

/// A stiff block bonded to the clay: a rough footing. Water lets nothing out at this permeability.
Spec footing(materials::Drainage drainage, double load) {
  constexpr double right = 4.0 * width, depth = 1.25 * width;
  Spec spec;
  spec.box = {0.0, -depth, right, block};
  spec.cell_size = cell;
  spec.gravity = 9.81;
  spec.scheme.fraction = 0.9;
  spec.water = {0.0, {.bulk_modulus = 2.2e9}};
  materials::MohrCoulomb clay;
  Soil soil{.name = "clay"};
  soil.pores = {.porosity = 0.45, .grain_density = 2650.0, .permeability = 1e-10, .drainage = drainage};
  clay.elastic = {materials::saturated_density(*soil.pores, spec.water->fluid), 18e6, 0.25}; // K_f/M = 102
  clay.cohesion_peak = clay.cohesion_residual = cohesion;
  soil.law = clay;
  soil.damping_time = 1e-3;
  spec.soils = {soil, {"block", materials::LinearElastic{{load / (spec.gravity * block), 2e8, 0.0}}}};
  spec.regions = {{0, {{0.0, -depth}, {right, -depth}, {right, 0.0}, {0.0, 0.0}}},
                  {1, {{left, 0.0}, {left + width, 0.0}, {left + width, block}, {left, block}}}};
  return spec;
}

/// How far pressure jumps from cell to cell beyond what a smooth field does, Pa: the largest difference
/// between the means of the two diagonals of four cells. A slope that changes from row to row or from column
/// to column leaves none. The nearest cells to the edges of the footing, where pressure has a true jump, are
/// left out, and those at the walls, beyond the soil that flows.
double largest_jump(const Domain& domain) {
  std::map<std::pair<int, int>, double> cells; // a pressure is that of its cell
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
      cells[{static_cast<int>(std::floor(set.x_initial[k] / cell)),
             static_cast<int>(std::floor(set.y_initial[k] / cell))}] = excess_pressure(set, k);
  double largest = 0.0;
  for (const auto& [at, p] : cells) {
    const auto [i, j] = at;
    const double x = (i + 1) * cell, depth = -(j + 1) * cell;
    const double from_edge = std::min(std::abs(x - left), std::abs(x - left - width));
    const double from_wall = std::min(x, 4.0 * width - x);
    if (std::hypot(from_edge, depth) < 0.2 * width || from_wall < 0.2 * width ||
        !cells.contains({i + 1, j + 1}))
      continue;
    const double jump = 0.5 * (p + cells.at({i + 1, j + 1}) - cells.at({i + 1, j}) - cells.at({i, j + 1}));
    largest = std::max(largest, std::abs(jump));
  }
  return largest;
}

class HardCase23UndrainedFooting : public testing::TestWithParam<materials::Drainage> {};

TEST_P(HardCase23UndrainedFooting, UndrainedFootingCarriesItsLimitLoad) {
  constexpr double at_rest_under = 4.0; // over c
  const auto domain = std::make_unique<Domain>(footing(GetParam(), at_rest_under * cohesion));
  replace_constraints(*domain, relax_under_gravity(*domain, {.residual = 1e-6}, [](long, double) {}));
  for (BoundaryFace& face : domain->boundary.faces()) { // rigid walls
    face.ground.impedance_p *= 1e6;
    face.ground.impedance_s *= 1e6;
  }
  const GrowingLoad load(*domain, "block");
  const Particles& stone = *std::ranges::find_if(
      domain->sets, [](const Particles& s) { return s.soil == "block" && s.size() > 0; });
  Stepper stepper(*domain, 0.0, quiet_ground());
  const auto settlement = [&] {
    double sum = 0.0;
    for (std::size_t k = 0; k < stone.size(); ++k)
      sum += stone.y_initial[k] - stone.y[k];
    return sum / static_cast<double>(stone.size());
  };
  /// Takes the load from one value to another, both over c, and holds it; how far the footing sinks at the
  /// end.
  const auto sinks = [&](double from, double to) {
    constexpr double ramp = 0.15, wait = 0.2, look = 0.15; // s
    const double begin = stepper.time();
    const auto until = [&](double end) {
      while (stepper.time() < begin + end) {
        load.grow((from + (to - from) * smooth_step((stepper.time() - begin) / ramp)) / at_rest_under);
        stepper.step();
      }
    };
    until(ramp + wait);
    const double before = settlement();
    until(ramp + wait + look);
    return settlement() - before;
  };
  bounded("sinking at 5.1 c", sinks(at_rest_under, 5.1), 1e-3, "m in 0.15 s");
  bounded("jump of pressure over the load", largest_jump(*domain) / (5.1 * cohesion), 0.05);
  reaches("sinking at 5.6 c", sinks(5.1, 5.6), 3e-3, "m in 0.15 s");
  bounded("jump of pressure over the load as the clay flows", largest_jump(*domain) / (5.6 * cohesion), 0.05);
  bounded("energy", ledger_error(domain->energy), 0.02);
}

std::string name_of(const testing::TestParamInfo<materials::Drainage>& drainage) {
  return std::string(tremolo::name(drainage.param));
}

INSTANTIATE_TEST_SUITE_P(Drainages, HardCase23UndrainedFooting,
                         testing::Values(materials::Drainage::undrained), name_of);
INSTANTIATE_TEST_SUITE_P(AcceptanceDrainages, HardCase23UndrainedFooting,
                         testing::Values(materials::Drainage::coupled), name_of);

} // namespace
} // namespace tremolo
