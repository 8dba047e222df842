#include "wavefield/layers/reflectivity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
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

/// Waves at the surface of a half-space: incident, reflected P, reflected SV, per unit incident velocity.
struct Reflected {
  explicit Reflected(const HalfSpace& soil, WaveType wave, double degrees)
      : reflectivity({.half_space = soil}, wave, radians(degrees)) {
    const LayerAmplitudes& amplitudes = reflectivity.solve(0.0).front();
    const WaveBasis& basis = reflectivity.basis(0);
    r_p = amplitudes.down[0];
    r_s = amplitudes.down[1];
    waves = {basis.up * amplitudes.up, basis.down.col(0) * r_p, basis.down.col(1) * r_s};
  }
  Eigen::Vector4cd sum() const { return waves[0] + waves[1] + waves[2]; }

  Reflectivity reflectivity;
  Complex r_p, r_s;
  std::array<Eigen::Vector4cd, 3> waves; ///< vx, vy, sxy / -Z, syy / -Z
};

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

TEST(Reflection, AmplifyAnIncidentShearWaveAtTheSurfaceByTheKnownFactors) {
  for (const Amplification& row : published) {
    const Eigen::Vector4cd surface = Reflected(with_poisson(row.poisson), WaveType::SV, row.degrees).sum();
    EXPECT_NEAR(std::abs(surface[0]), row.ux, 1e-6) << row.degrees << " " << row.poisson;
    EXPECT_NEAR(std::abs(surface[1]), row.uy, 1e-6) << row.degrees << " " << row.poisson;
  }
}

TEST(Reflection, ReflectTheKnownAmplitudes) {
  const HalfSpace soil = with_poisson(0.28);
  const Reflected at_40(soil, WaveType::SV, 40.0);
  EXPECT_NEAR(std::abs(at_40.r_s - Complex(-0.989513, 0.144441)), 0.0, 1e-6);
  EXPECT_NEAR(std::abs(at_40.r_p - Complex(0.032875, 0.452812)), 0.0, 1e-6);
  const Reflected at_33(soil, WaveType::SV, 33.5);
  EXPECT_NEAR(std::abs(at_33.r_s - 0.663896), 0.0, 1e-6);
  EXPECT_NEAR(std::abs(at_33.r_p - 2.166802), 0.0, 1e-6);
  EXPECT_NEAR(std::abs(Reflected(with_poisson(0.25), WaveType::SV, 30.0).r_s), 0.0, 1e-14);
}

TEST(Reflection, LeaveTheSurfaceFreeOfTractionAtAnyAngle) {
  for (const WaveType wave : {WaveType::SV, WaveType::P}) {
    for (double degrees = 0.0; degrees < 90.0; degrees += 0.25) {
      const HalfSpace soil = with_poisson(0.28);
      const Eigen::Vector4cd surface = Reflected(soil, wave, degrees).sum();
      EXPECT_LT(std::abs(surface[2]), 1e-14 * soil.vp / soil.vs) << degrees;
      EXPECT_LT(std::abs(surface[3]), 1e-14 * soil.vp / soil.vs) << degrees;
    }
  }
}

/// Mean power that a wave carries upwards, -Re(sigma_y . conj(v)) / 2, over Z.
double flux_up(const Eigen::Vector4cd& wave) {
  return 0.5 * (wave[2] * std::conj(wave[0]) + wave[3] * std::conj(wave[1])).real();
}

TEST(Reflection, CarryDownWhatCameUp) {
  for (const double poisson : {0.0, 0.25, 0.28, 0.45}) {
    const HalfSpace soil = with_poisson(poisson);
    for (const WaveType wave : {WaveType::SV, WaveType::P}) {
      for (double degrees = 0.1; degrees < 90.0; degrees += 0.35) {
        const auto waves = Reflected(soil, wave, degrees).waves;
        const double speed = (wave == WaveType::SV ? soil.vs : soil.vp) / soil.vs;
        EXPECT_NEAR(flux_up(waves[0]), 0.5 * speed * std::cos(radians(degrees)), 1e-10 * speed);
        EXPECT_NEAR(flux_up(waves[0]) + flux_up(waves[1]) + flux_up(waves[2]), 0.0, 1e-13 * speed);
      }
    }
  }
}

TEST(Reflection, AreRegularAtVerticalIncidence) {
  const HalfSpace soil = with_poisson(0.28);
  for (const WaveType wave : {WaveType::SV, WaveType::P}) {
    const Reflected vertical(soil, wave, 0.0);
    const Reflected almost(soil, wave, 1e-9 * 180.0 / std::numbers::pi);
    for (std::size_t i = 0; i < vertical.waves.size(); ++i) {
      EXPECT_LT((vertical.waves[i] - almost.waves[i]).norm(), 1e-8);
    }
    EXPECT_EQ(std::abs(vertical.sum()[wave == WaveType::SV ? 1 : 0]), 0.0);
  }
}

TEST(Reflection, DecayWithDepthBeyondTheCriticalAngle) {
  const HalfSpace soil = with_poisson(0.25); // critical at 35.264 degrees
  EXPECT_FALSE(is_post_critical(soil, incident(WaveType::SV, 35.26)));
  EXPECT_TRUE(is_post_critical(soil, incident(WaveType::SV, 35.27)));
  EXPECT_FALSE(is_post_critical(soil, incident(WaveType::P, 80.0)));
  const Reflected waves(soil, WaveType::SV, 50.0);
  const Complex s(0.0, 6.0);
  const Complex phase_at_depth = std::exp(s * waves.reflectivity.basis(0).q[0] * -10.0); // y = -10 m
  EXPECT_LT(std::abs(phase_at_depth), 1.0);
  EXPECT_NEAR(std::abs(waves.r_s), 1.0, 1e-14);
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
