#include "wavefield/plane_waves.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace {

using namespace tremolo::wavefield;
using Complex = std::complex<double>;

HalfSpace with_poisson(double poisson) {
  const double vs = 200.0;
  return {1800.0, vs, vs * std::sqrt((2.0 - 2.0 * poisson) / (1.0 - 2.0 * poisson))};
}

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

Incidence incident(WaveType wave, double degrees) {
  return {wave, radians(degrees), 0.0, 0.0};
}

Complex sum(const PlaneWaves& waves, Complex PlaneWave::*quantity) {
  return waves[0].*quantity + waves[1].*quantity + waves[2].*quantity;
}

/// R_P and R_S: amplitude of particle velocity along the unit vectors (p, -q) a and (q, p) b of the reflected
/// waves.
Complex reflected_p(const HalfSpace& soil, const PlaneWaves& waves) {
  const double p = waves[1].q.imag() == 0.0 ? std::sqrt(1.0 / (soil.vp * soil.vp) - std::norm(waves[1].q))
                                            : std::sqrt(1.0 / (soil.vp * soil.vp) + std::norm(waves[1].q));
  return waves[1].vx / (soil.vp * p);
}
Complex reflected_s(const HalfSpace& soil, const PlaneWaves& waves) {
  return -waves[2].vx / (soil.vs * waves[2].q);
}

struct Amplification {
  double degrees;
  double poisson;
  double ux, uy; ///< at the surface for a unit incident SV wave
};

// 15 and 33.5 degrees: below critical; 36 to 60: beyond, where the motion is an ellipse; 45: no shear-wave
// conversion; at 30 degrees and nu = 0.25 the reflection is all P.
const Amplification published[] = {{0.0, 0.25, 2.0, 0.0},
                                   {0.0, 1.0 / 3.0, 2.0, 0.0},
                                   {15.0, 0.25, 1.893485, 0.584091},
                                   {15.0, 0.28, 1.908948, 0.557309},
                                   {15.0, 1.0 / 3.0, 1.943753, 0.497024},
                                   {30.0, 0.25, 1.732051, 1.0},
                                   {30.0, 0.28, 1.907023, 0.898979},
                                   {33.5, 0.25, 2.006255, 0.960197},
                                   {33.5, 0.28, 3.551033, 0.304477},
                                   {33.5, 1.0 / 3.0, 2.307995, 1.524086},
                                   {36.0, 0.25, 3.206424, 1.344997},
                                   {36.0, 0.28, 2.057795, 1.564409},
                                   {36.0, 1.0 / 3.0, 1.394913, 1.639819},
                                   {40.0, 0.25, 0.741055, 1.550227},
                                   {40.0, 0.28, 0.638876, 1.551640},
                                   {40.0, 1.0 / 3.0, 0.519306, 1.553027},
                                   {45.0, 0.25, 0.0, 1.414214},
                                   {45.0, 0.28, 0.0, 1.414214},
                                   {60.0, 0.25, 0.5, 1.118034},
                                   {60.0, 0.28, 0.485071, 1.120224},
                                   {60.0, 1.0 / 3.0, 0.458831, 1.123903}};

TEST(PlaneWaves, AmplifyAnIncidentShearWaveAtTheSurfaceByTheKnownFactors) {
  for (const Amplification& row : published) {
    const auto waves = plane_waves(with_poisson(row.poisson), incident(WaveType::SV, row.degrees));
    EXPECT_NEAR(std::abs(sum(waves, &PlaneWave::vx)), row.ux, 1e-6) << row.degrees << " " << row.poisson;
    EXPECT_NEAR(std::abs(sum(waves, &PlaneWave::vy)), row.uy, 1e-6) << row.degrees << " " << row.poisson;
  }
}

TEST(PlaneWaves, ReflectTheKnownAmplitudes) {
  const HalfSpace soil = with_poisson(0.28);
  const auto at_40 = plane_waves(soil, incident(WaveType::SV, 40.0));
  EXPECT_NEAR(std::abs(reflected_s(soil, at_40) - Complex(-0.989513, 0.144441)), 0.0, 1e-6);
  EXPECT_NEAR(std::abs(reflected_p(soil, at_40) - Complex(0.032875, 0.452812)), 0.0, 1e-6);
  const auto at_33 = plane_waves(soil, incident(WaveType::SV, 33.5));
  EXPECT_NEAR(std::abs(reflected_s(soil, at_33) - 0.663896), 0.0, 1e-6);
  EXPECT_NEAR(std::abs(reflected_p(soil, at_33) - 2.166802), 0.0, 1e-6);
  const auto total_conversion = plane_waves(with_poisson(0.25), incident(WaveType::SV, 30.0));
  EXPECT_NEAR(std::abs(total_conversion[2].vx), 0.0, 1e-14);
}

TEST(PlaneWaves, LeaveTheSurfaceFreeOfTractionAtAnyAngle) {
  for (const WaveType wave : {WaveType::SV, WaveType::P}) {
    for (double degrees = 0.0; degrees < 90.0; degrees += 0.25) {
      const HalfSpace soil = with_poisson(0.28);
      const auto waves = plane_waves(soil, incident(wave, degrees));
      const double impedance = soil.density * soil.vp;
      EXPECT_LT(std::abs(sum(waves, &PlaneWave::sxy)), 1e-14 * impedance) << degrees;
      EXPECT_LT(std::abs(sum(waves, &PlaneWave::syy)), 1e-14 * impedance) << degrees;
    }
  }
}

/// Mean power that a wave carries upwards, -Re(sigma_y . conj(v)) / 2.
double flux_up(const PlaneWave& wave) {
  return -0.5 * (wave.sxy * std::conj(wave.vx) + wave.syy * std::conj(wave.vy)).real();
}

TEST(PlaneWaves, CarryDownWhatCameUp) {
  for (const double poisson : {0.0, 0.25, 0.28, 0.45}) {
    const HalfSpace soil = with_poisson(poisson);
    for (const WaveType wave : {WaveType::SV, WaveType::P}) {
      for (double degrees = 0.1; degrees < 90.0; degrees += 0.35) {
        const auto waves = plane_waves(soil, incident(wave, degrees));
        const double speed = wave == WaveType::SV ? soil.vs : soil.vp;
        EXPECT_NEAR(flux_up(waves[0]), 0.5 * soil.density * speed * std::cos(radians(degrees)),
                    1e-10 * soil.density * speed);
        EXPECT_NEAR(flux_up(waves[0]) + flux_up(waves[1]) + flux_up(waves[2]), 0.0,
                    1e-13 * soil.density * speed);
      }
    }
  }
}

TEST(PlaneWaves, AreRegularAtVerticalIncidence) {
  const HalfSpace soil = with_poisson(0.28);
  for (const WaveType wave : {WaveType::SV, WaveType::P}) {
    const auto vertical = plane_waves(soil, incident(wave, 0.0));
    const auto almost = plane_waves(soil, {wave, 1e-9, 0.0, 0.0});
    for (std::size_t i = 0; i < vertical.size(); ++i) {
      EXPECT_LT(std::abs(vertical[i].vx - almost[i].vx), 1e-8);
      EXPECT_LT(std::abs(vertical[i].vy - almost[i].vy), 1e-8);
      EXPECT_LT(std::abs(vertical[i].sxx - almost[i].sxx), 1e-8 * soil.density * soil.vp);
    }
    EXPECT_EQ(std::abs(sum(vertical, wave == WaveType::SV ? &PlaneWave::vy : &PlaneWave::vx)), 0.0);
  }
}

TEST(PlaneWaves, DecayWithDepthBeyondTheCriticalAngle) {
  const HalfSpace soil = with_poisson(0.25); // critical at 35.264 degrees
  EXPECT_FALSE(is_post_critical(soil, incident(WaveType::SV, 35.26)));
  EXPECT_TRUE(is_post_critical(soil, incident(WaveType::SV, 35.27)));
  EXPECT_FALSE(is_post_critical(soil, incident(WaveType::P, 80.0)));
  const auto waves = plane_waves(soil, incident(WaveType::SV, 50.0));
  const Complex phase_at_depth =
      std::exp(Complex(0.0, -1.0) * waves[1].q * -10.0 * 6.0); // w = 6 1/s, y = -10 m
  EXPECT_LT(std::abs(phase_at_depth), 1.0);
  EXPECT_NEAR(std::abs(reflected_s(soil, waves)), 1.0, 1e-14);
}

void expect_refused(const HalfSpace& soil, const std::string& words) {
  EXPECT_THAT([&] { validate(soil); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr(words)));
}

TEST(HalfSpaceValidation, NamesTheQuantityAndTheAllowedRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused({nan, 200.0, 400.0}, "half-space density is nan, must be positive");
  expect_refused({1800.0, -200.0, 400.0}, "half-space vs is -200, must be positive");
  expect_refused({1800.0, 200.0, 230.0}, "half-space vp is 230, must be above sqrt(4/3) vs");
  EXPECT_THROW(validate(incident(WaveType::SV, 90.0)), std::invalid_argument);
  EXPECT_THROW(validate(incident(WaveType::SV, -1.0)), std::invalid_argument);
  EXPECT_THROW(validate(incident(WaveType::SV, nan)), std::invalid_argument);
  EXPECT_THROW(validate(Incidence{WaveType::P, 0.0, nan, 0.0}), std::invalid_argument);
  EXPECT_NO_THROW(validate(incident(WaveType::P, 89.99)));
}

} // namespace
