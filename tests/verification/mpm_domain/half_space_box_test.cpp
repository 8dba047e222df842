// The whole chain of the domain (faces, Eq. (6), transfer, law) against the exact field of an oblique SV wave
// in a half-space, without processes.

#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tremolo {
namespace {

using mpm_domain::StepOrder;
using mpm_domain::Transfer;
using test_support::BoxResult;
using test_support::run_box;

// 3 Hz at h = 0.5 m is 64 cells per wavelength; the pulse's energy reaches to about three times that
// frequency.
TEST(AcceptanceHalfSpaceBox, ObliqueWaveConvergesAtSecondOrder) {
  const BoxResult coarse = run_box(1.0, 15.0, true);
  const BoxResult fine = run_box(0.5, 15.0, true);
  RecordProperty("error_h_0.5", std::to_string(fine.error));
  EXPECT_LT(fine.error, 0.01);
  EXPECT_GT(std::log2(coarse.error / fine.error), 1.8);
  EXPECT_LT(coarse.residual, 0.02);
  EXPECT_LT(fine.residual, 0.02);
}

// The incident form asks the base dashpots to absorb the free field's own reflections, which they cannot do
// obliquely: at 15 degrees it costs about 3 % of the wave, at 0 degrees nothing.
TEST(HalfSpaceBox, IncidentBaseIsExactOnlyAtVerticalIncidence) {
  const BoxResult vertical = run_box(1.0, 0.0, true);
  EXPECT_LT(vertical.error, 0.035);
  EXPECT_LT(vertical.residual, 0.02);
  const double vertical_incident = run_box(1.0, 0.0, false).error;
  EXPECT_NEAR(vertical_incident, vertical.error, 1e-3 * vertical.error);
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
