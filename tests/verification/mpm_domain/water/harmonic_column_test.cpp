// A saturated column under a harmonic load on its drained surface, against both waves of Biot, up and down
// (verification C5). The load is the weight of a thin dry layer, which changes; its mass does not, and is
// next to nothing.

#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "tests/support/growing_load.hpp"
#include "tests/support/harmonic_column.hpp"
#include "tests/verification/mpm_domain/water/saturated_column.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace tremolo::mpm_domain {
namespace {

struct Load {
  double frequency;    ///< Hz
  double permeability; ///< m/s
};

class HarmonicLoad : public testing::TestWithParam<Load> {};

TEST_P(HarmonicLoad, PressureAndDisplacementHaveTheirAmplitudes) {
  const auto [frequency, permeability] = GetParam();
  constexpr double cell = 0.25;
  test_support::SaturatedColumn column;
  column.height = 10.0;
  column.cell = cell;
  column.p_modulus = 1e8;
  column.poisson = 0.25;
  column.pores.permeability = permeability;
  column.scheme.fraction = 0.9;
  column.load = 10.0; // Pa at rest: 1 kg/m2 over 20 t/m2
  const auto domain = column.at_rest();
  for (BoundaryFace& face : domain->boundary.faces())
    face.ground.impedance_p *= 1e6; // rigid
  Particles& layer = *std::ranges::find_if(
      domain->sets, [](const Particles& set) { return set.soil == "load" && set.size() > 0; });
  Stepper stepper(*domain, 0.0, test_support::at_rest_source());
  const double w = 2.0 * std::numbers::pi * frequency;
  constexpr double times = 100.0; // amplitude over the weight at rest
  constexpr double ramp = 2.0;    // periods; what it leaves dies out by drag within one more
  const auto step = [&] {
    const double t = stepper.time();
    layer.weight_share = 1.0 - times * test_support::smooth_step(t * frequency / ramp) * std::sin(w * t);
    stepper.step();
  };
  constexpr std::array heights = {0.5 * cell, 5.0 + 0.5 * cell, 9.0 + 0.5 * cell}; // m, centres of cells
  constexpr double near_top = 10.0 - 0.25 * cell; // m, where the highest wet particle lies
  const freefield::testing::HarmonicColumn exact(column.height, column.p_modulus, permeability, frequency);
  while (stepper.time() < 3.0 / frequency)
    step();
  std::array<std::complex<double>, 3> pressure{};
  std::complex<double> top;
  const double begin = stepper.time();
  const auto steps = static_cast<long>(std::lround(1.0 / frequency / stepper.dt()));
  for (long i = 0; i < steps; ++i) {
    step();
    const auto phase = std::polar(2.0 / static_cast<double>(steps), -w * (stepper.time() - begin));
    for (const Particles& set : domain->sets)
      for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k) {
        const double height = set.y_initial[k] + column.height;
        for (std::size_t h = 0; h < heights.size(); ++h)
          if (std::abs(height - heights[h]) < 0.5 * column.cell)
            pressure[h] += 0.25 * phase * excess_pressure(set, k);
        if (std::abs(height - near_top) < 0.1 * column.cell)
          top += 0.5 * phase * (set.y[k] - set.y_initial[k]);
      }
  }
  const double amplitude = times * column.load;
  for (std::size_t h = 0; h < heights.size(); ++h) {
    const double expected = std::abs(exact.pressure(heights[h]));
    EXPECT_NEAR(std::abs(pressure[h]) / amplitude, expected, 0.0075 * expected) << heights[h] << " m high";
  }
  const double expected = std::abs(exact.displacement(near_top));
  EXPECT_NEAR(std::abs(top) / amplitude, expected, 0.0075 * expected);
}

std::string name_of(const testing::TestParamInfo<Load>& load) {
  return fmt::format("At{:g}Hz{}", load.param.frequency, load.param.permeability > 5e-3 ? "Permeable" : "");
}

INSTANTIATE_TEST_SUITE_P(Loads, HarmonicLoad, testing::Values(Load{10.0, 1e-3}), name_of);
INSTANTIATE_TEST_SUITE_P(AcceptanceLoads, HarmonicLoad, testing::Values(Load{2.0, 1e-3}, Load{2.0, 1e-2}),
                         name_of);

} // namespace
} // namespace tremolo::mpm_domain
