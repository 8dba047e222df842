// What reduced dispersion makes of waves in the middle of tall ground: the rows "interior" of
// docs/dispersion.md, with 0.6 h/c_p as the step.

#include "tests/support/plane_pulse.hpp"
#include "tests/support/pulse_column.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tremolo {
namespace {

using mpm_domain::Dispersion;
using test_support::PlanePulse;
using test_support::PulseGround;
using test_support::PulseResult;

/// A Ricker pulse that goes up `way` wavelengths of `cells` cells each.
PulseResult upwards(bool sv, double cells, double way, Dispersion dispersion) {
  const PlanePulse pulse{.sv = sv, .wavelength = 1.0, .spacing = 3.0};
  return travel(pulse, {.h = 1.0 / cells, .width = 1.0 / cells, .travelled = way, .strip = 3.0}, dispersion);
}

/// Obliquely at 45 degrees; `period` cells across hold one spacing of the pulses, three wavelengths.
PulseResult obliquely(bool sv, int period, double way, Dispersion dispersion) {
  const double spacing = period / std::sqrt(2.0);
  const double wavelength = spacing / 3.0;
  const PlanePulse pulse{.sv = sv, .angle_deg = 45.0, .wavelength = wavelength, .spacing = spacing};
  return travel(pulse,
                {.h = 1.0, .width = double(period), .travelled = way * wavelength, .strip = 2.0 * wavelength},
                dispersion);
}

TEST(ReducedDispersion, ShearPulseOverTenWavelengthsAlongAnAxis) {
  EXPECT_NEAR(upwards(true, 16.0, 10.0, Dispersion::plain).error, 0.68, 0.01); // what it is without
  EXPECT_LT(upwards(true, 16.0, 10.0, Dispersion::reduced).error, 0.01);
  EXPECT_LT(upwards(true, 12.0, 10.0, Dispersion::reduced).error, 0.025);
}

TEST(ReducedDispersion, ObliqueShearPulseOverSixWavelengths) {
  const PulseResult plain = obliquely(true, 51, 6.0, Dispersion::plain); // 12.02 cells to the wavelength
  const PulseResult reduced = obliquely(true, 51, 6.0, Dispersion::reduced);
  EXPECT_NEAR(plain.error, 0.71, 0.01);
  EXPECT_LT(plain.energy, -0.2);
  EXPECT_LT(reduced.error, 0.056);
  EXPECT_LT(std::abs(reduced.energy), 0.005);
}

TEST(ReducedDispersion, CompressionPulseOverTenWavelengths) {
  EXPECT_NEAR(upwards(false, 24.0, 10.0, Dispersion::plain).error, 0.25, 0.01);
  EXPECT_LT(upwards(false, 24.0, 10.0, Dispersion::reduced).error, 0.01);
}

/// One harmonic, which fits into 14 or 28 cells across: 9.9 or 19.8 cells to the wavelength.
PulseResult harmonic(bool sv, int period, Dispersion dispersion) {
  const double wavelength = period / std::sqrt(2.0);
  const PlanePulse wave{.sv = sv, .harmonic = true, .angle_deg = 45.0, .wavelength = wavelength};
  return travel(wave,
                {.h = 1.0, .width = double(period), .travelled = 3.0 * wavelength, .strip = 2.0 * wavelength},
                dispersion);
}

TEST(ReducedDispersion, PhaseVelocityOfObliqueWaves) {
  EXPECT_NEAR(harmonic(true, 14, Dispersion::plain).phase, -0.0184, 0.0005);
  EXPECT_NEAR(harmonic(false, 14, Dispersion::plain).phase, -0.0240, 0.0005);
  for (const bool sv : {true, false})
    EXPECT_LT(std::abs(harmonic(sv, 14, Dispersion::reduced).phase), 0.0005);
}

TEST(ReducedDispersion, ObliqueShearWavesConvergeAtFourthOrder) {
  const double coarse = harmonic(true, 14, Dispersion::reduced).error;
  const double fine = harmonic(true, 28, Dispersion::reduced).error;
  EXPECT_GT(std::log2(coarse / fine), 3.8);
}

/// @param particles  a cell and direction
void expect_small_errors(int particles) {
  const PlanePulse up{.wavelength = 1.0, .spacing = 3.0};
  const PulseGround tall{
      .h = 1.0 / 16.0, .width = 1.0 / 16.0, .travelled = 10.0, .strip = 3.0, .particles_per_cell = particles};
  EXPECT_LT(travel(up, tall, Dispersion::reduced).error, 0.015);
  const double spacing = 51.0 / std::sqrt(2.0);
  const double wavelength = spacing / 3.0;
  const PlanePulse oblique{.angle_deg = 45.0, .wavelength = wavelength, .spacing = spacing};
  const PulseGround wide{.h = 1.0,
                         .width = 51.0,
                         .travelled = 6.0 * wavelength,
                         .strip = 2.0 * wavelength,
                         .particles_per_cell = particles};
  EXPECT_LT(travel(oblique, wide, Dispersion::reduced).error, 0.056);
}

TEST(ReducedDispersion, ThreeParticlesACellAndDirection) {
  expect_small_errors(3);
}

TEST(AcceptanceReducedDispersion, FourParticlesACellAndDirection) {
  expect_small_errors(4);
}

TEST(ReducedDispersion, TheBaseSendsBackAThirdOrderOfAPulse) {
  const double coarse = test_support::left_behind(16.0, Dispersion::reduced);
  const double fine = test_support::left_behind(32.0, Dispersion::reduced);
  EXPECT_LT(coarse, test_support::left_behind(16.0, Dispersion::plain));
  EXPECT_GT(std::log2(coarse / fine), 2.7);
}

} // namespace
} // namespace tremolo
