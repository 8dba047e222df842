// Factors of safety that are known (known_safety.hpp): each model stands with 0.95 of its factor and fails with
// 1.05 of it.

#include "mpm_domain/gravity/held_soil.hpp"
#include "mpm_domain/gravity/strength_reduction.hpp"
#include "tests/support/hard_case.hpp"
#include "tests/verification/mpm_domain/limit_loads/known_safety.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tremolo::mpm_domain {
namespace {

using test::BishopSlope;

bool stands_with(const Spec& spec, double factor) {
  return try_factor(spec, factor, [](const StrengthTrial&) {}).stands.has_value();
}

void expect_factor(const std::string& what, const Spec& spec, double factor, double tolerance = 0.05) {
  test_support::exactly(what + ", 0.95 of its factor: stands", stands_with(spec, (1.0 - tolerance) * factor), true);
  test_support::exactly(what + ", 1.05 of its factor: stands", stands_with(spec, (1.0 + tolerance) * factor), false);
}

class Bishop : public testing::TestWithParam<BishopSlope> {};

TEST_P(Bishop, SlopeHasTheFactorOfItsCircle) {
  expect_factor(testing::PrintToString(GetParam()), spec_of(GetParam()), GetParam().factor);
}

INSTANTIATE_TEST_SUITE_P(Slopes, Bishop,
                         testing::Values(BishopSlope{3.0, 30.0, 0.025, 2000.0 * 9.81, true, 1.0, 2.58}));
INSTANTIATE_TEST_SUITE_P(AcceptanceSlopes, Bishop,
                         testing::Values(BishopSlope{2.0, 20.0, 0.05, 20e3, false, 1.0, 1.383},
                                         BishopSlope{2.0, 20.0, 0.05, 20e3, true, 1.0, 1.82},
                                         BishopSlope{3.0, 30.0, 0.025, 2000.0 * 9.81, false, 1.0, 2.256}));

} // namespace
} // namespace tremolo::mpm_domain
