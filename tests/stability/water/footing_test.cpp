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

constexpr double cohesion = 20e3; // c, Pa
constexpr double width = 4.0;     // B of the footing, m
const double cell = getenv("CELL") ? atof(getenv("CELL")) : 0.4;      // m: B/h = 10
constexpr double block = 0.8;     // height of the footing, m

/// A stiff block bonded to the clay: a rough footing. Water lets nothing out at this permeability.
Spec footing(materials::Drainage drainage, double load) {
  constexpr double right = 4.0 * width, depth = 1.2 * width;
  Spec spec;
  spec.box = {0.0, -depth, right, block};
  spec.cell_size = cell;
  spec.gravity = 9.81;
  spec.scheme.fraction = 0.9;
  spec.water = {0.0, {.bulk_modulus = 5e8}};
  materials::MohrCoulomb clay;
  Soil soil{.name = "clay"};
  soil.pores = {.porosity = 0.45, .grain_density = 2650.0, .permeability = 1e-10, .drainage = drainage};
  clay.elastic = {materials::saturated_density(*soil.pores, spec.water->fluid), 4e6, 0.25}; // K_f/M = 104
  clay.cohesion_peak = clay.cohesion_residual = cohesion;
  soil.law = clay;
  soil.damping_time = 2e-3;
  if (getenv("DRY")) { soil.pores.reset(); clay.elastic.poisson = 0.495; soil.law = clay; }
  if (getenv("BETA")) soil.damping_time = atof(getenv("BETA"));
  if (getenv("FLIP")) spec.scheme.transfer = Transfer::flip;
  spec.soils = {soil, {"block", materials::LinearElastic{{load / (spec.gravity * block), 2e8, 0.0}}}};
  constexpr double left = 1.5 * width;
  spec.regions = {{0, {{0.0, -depth}, {right, -depth}, {right, 0.0}, {0.0, 0.0}}},
                  {1, {{left, 0.0}, {left + width, 0.0}, {left + width, block}, {left, block}}}};
  return spec;
}

/// The largest difference of excess pressure between cells side by side, below the footing and beside it, Pa.
double largest_jump(const Domain& domain) {
  std::map<std::pair<int, int>, double> cells; // a pressure is that of its cell
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
      cells[{static_cast<int>(std::floor(set.x_initial[k] / cell)),
             static_cast<int>(std::floor(set.y_initial[k] / cell))}] = excess_pressure(set, k);
  double largest = 0.0;
  for (const auto& [at, p] : cells) {
    const auto next = [&](int i, int j) { return cells.find({at.first + i, at.second + j}); };
    const auto left = next(-1, 0), right = next(1, 0), below = next(0, -1), above = next(0, 1);
    for (const auto& [one, other] : {std::pair{left, right}, {below, above}})
      if (one != cells.end() && other != cells.end())
        largest = std::max(largest, std::abs(p - 0.5 * (one->second + other->second)));
  }
  return largest;
}

class HardCase23 : public testing::TestWithParam<materials::Drainage> {};

TEST_P(HardCase23, UndrainedFootingCarriesItsLimitLoad) {
  constexpr double before = 4.0; // over c, at rest
  const auto domain = std::make_unique<Domain>(footing(GetParam(), before * cohesion));
  replace_constraints(*domain, relax_under_gravity(*domain, {.residual = 1e-6}, [](long, double) {}));
  for (BoundaryFace& face : domain->boundary.faces()) { // rigid walls
    face.ground.impedance_p *= 1e6;
    face.ground.impedance_s *= 1e6;
  }
  const GrowingLoad load(*domain, "block");
  const Particles& stone = *std::ranges::find_if(
      domain->sets, [](const Particles& s) { return s.soil == "block" && s.size() > 0; });
  Stepper stepper(*domain, 0.0, quiet_ground());
  const auto sinking = [&] {
    double sum = 0.0;
    for (const double v : stone.vy)
      sum -= v;
    return sum / static_cast<double>(stone.size());
  };
  const auto settled = [&] {
    double sum = 0.0;
    for (std::size_t k = 0; k < stone.size(); ++k)
      sum += stone.y_initial[k] - stone.y[k];
    return sum / static_cast<double>(stone.size());
  };
  const auto load_to = [&](double from, double to, double time, double hold) {
    const double begin = stepper.time();
    int look = 0;
    while (stepper.time() < begin + time + hold) {
      load.grow((from + (to - from) * smooth_step((stepper.time() - begin) / time)) / before);
      stepper.step();
      if (stepper.time() - begin > 0.25 * look) {
        ++look;
        printf("t %.3f load %.3f v %.5f s %.5f jump %.4f of max p %.4f min %g steps %ld\n", stepper.time(),
               (from + (to - from) * smooth_step((stepper.time() - begin) / time)), sinking(), settled(),
               largest_jump(*domain) / cohesion, largest_wet(*domain, excess_pressure) / cohesion,
               largest_wet(*domain, [](auto& s, auto k) { return -excess_pressure(s, k); }) / cohesion,
               stepper.steps());
        fflush(stdout);
      }
    }
  };
  [[maybe_unused]] const auto dump = [&] {
    std::map<std::pair<int, int>, std::pair<double, int>> cells;
    for (const Particles& set : domain->sets)
      for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k) {
        auto& c = cells[{static_cast<int>(std::floor(set.x_initial[k] / cell)),
                         static_cast<int>(std::floor(set.y_initial[k] / cell))}];
        c.first += excess_pressure(set, k);
        ++c.second;
      }
    for (int j = -1; j >= -12; --j) {
      for (int i = 6; i < 34; ++i)
        printf("%5.2f ", cells[{i, j}].first / cells[{i, j}].second / cohesion);
      printf("\n");
    }
  };
  load_to(before, 5.1, 0.5, 1.0);
  load_to(5.1, 5.6, 0.5, 1.0);
  load_to(5.6, 6.2, 0.5, 1.0);
  load_to(6.2, 7.0, 0.5, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Water, HardCase23,
                         testing::Values(materials::Drainage::undrained, materials::Drainage::coupled));

} // namespace
} // namespace tremolo
