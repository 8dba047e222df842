// The whole chain of the domain (faces, Eq. (6), transfer, law) against the exact field of an oblique SV wave
// in a half-space, without processes.

#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tremolo {
namespace {

using mpm_domain::StepOrder;
using mpm_domain::Transfer;
using test_support::PlaneWave;

struct BoxResult {
  double error = 0.0;    ///< relative L2 of particle velocity over the box and 2.2 s
  double residual = 0.0; ///< largest residual of the energy ledger over the work put in through the boundary
};

BoxResult run_box(double h, double angle_deg, bool total_base, const mpm_domain::Scheme& scheme = {}) {
  mpm_domain::Spec spec = test_support::elastic_box(100.0, 40.0, h);
  spec.scheme = scheme;
  mpm_domain::Domain domain(spec);
  PlaneWave wave;
  wave.angle = angle_deg * std::numbers::pi / 180.0;
  mpm_domain::Stepper stepper(domain, 0.0, test_support::plane_wave_source(domain, wave, total_base));
  test_support::VelocityError error;
  double input = 0.0;
  BoxResult result;
  while (stepper.time() < 2.2) {
    stepper.step();
    if (stepper.steps() % 8 == 0)
      error.add(domain, wave, stepper.velocity_time());
    input = std::max(input, domain.energy.input);
    result.residual = std::max(result.residual, std::abs(domain.energy.residual()));
  }
  result.residual /= input;
  result.error = error.relative();
  return result;
}

// 3 Hz at h = 0.5 m is 64 cells per wavelength; the pulse's energy reaches to about three times that
// frequency.
TEST(HalfSpaceBox, ObliqueWaveConvergesAtSecondOrder) {
  const BoxResult coarse = run_box(1.0, 15.0, true);
  const BoxResult fine = run_box(0.5, 15.0, true);
  RecordProperty("error_h_0.5", std::to_string(fine.error));
  EXPECT_LT(fine.error, 0.01);
  EXPECT_GT(std::log2(coarse.error / fine.error), 1.8);
  EXPECT_LT(coarse.residual, 0.02);
  EXPECT_LT(fine.residual, 0.02);
}

TEST(HalfSpaceBox, VerticalWave) {
  const BoxResult result = run_box(1.0, 0.0, true);
  EXPECT_LT(result.error, 0.035);
  EXPECT_LT(result.residual, 0.02);
}

// The incident form asks the base dashpots to absorb the free field's own reflections, which they cannot do
// obliquely: at 15 degrees it costs about 3 % of the wave, at 0 degrees nothing.
TEST(HalfSpaceBox, IncidentBaseIsExactOnlyAtVerticalIncidence) {
  const double vertical_total = run_box(1.0, 0.0, true).error;
  const double vertical_incident = run_box(1.0, 0.0, false).error;
  EXPECT_NEAR(vertical_incident, vertical_total, 1e-3 * vertical_total);
  const double oblique_total = run_box(1.0, 15.0, true).error;
  const double oblique_incident = run_box(1.0, 15.0, false).error;
  EXPECT_GT(oblique_incident, 1.2 * oblique_total);
  EXPECT_LT(oblique_incident, 0.05);
}

// Every scheme that a case may choose solves the same problem. FLIP's dispersion is about three times that of
// APIC.
class EveryScheme : public testing::TestWithParam<mpm_domain::Scheme> {};

TEST_P(EveryScheme, ObliqueWave) {
  const BoxResult result = run_box(1.0, 15.0, true, GetParam());
  EXPECT_LT(result.error, GetParam().transfer == Transfer::apic ? 0.035 : 0.11);
  EXPECT_LT(result.residual, 0.02);
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, EveryScheme,
    testing::Values(mpm_domain::Scheme{.transfer = Transfer::apic, .order = StepOrder::usl},
                    mpm_domain::Scheme{.transfer = Transfer::flip, .order = StepOrder::usl},
                    mpm_domain::Scheme{.transfer = Transfer::flip, .order = StepOrder::musl}));

} // namespace
} // namespace tremolo
