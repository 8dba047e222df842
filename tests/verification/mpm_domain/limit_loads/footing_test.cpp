// Prandtl's strip footing on clay. More meshes: cost_limit_loads.

#include "tests/verification/mpm_domain/limit_loads/expect_limit.hpp"
#include "tests/verification/mpm_domain/limit_loads/footing.hpp"

#include <gtest/gtest.h>

namespace tremolo::mpm_domain {
namespace {

using test::Footing;

class Prandtl : public testing::TestWithParam<Footing> {};

TEST_P(Prandtl, FootingCarriesTwoPlusPiTimesTheCohesion) {
  expect_stands(GetParam(), 0.95, true);
  expect_stands(GetParam(), 1.05, false);
}

INSTANTIATE_TEST_SUITE_P(Footings, Prandtl, testing::Values(Footing{true, 0.25, 0.3}));

INSTANTIATE_TEST_SUITE_P(AcceptanceFootings, Prandtl,
                         testing::Values(Footing{true, 0.25, 0.495}, Footing{true, 0.2, 0.3},
                                         Footing{true, 1.0 / 6.0, 0.3}, Footing{true, 0.2, 0.495},
                                         Footing{true, 1.0 / 6.0, 0.495}, Footing{false, 0.25, 0.3},
                                         Footing{false, 0.2, 0.3}, Footing{false, 1.0 / 6.0, 0.3},
                                         Footing{false, 0.25, 0.495}));

} // namespace
} // namespace tremolo::mpm_domain
