// Prandtl's strip footing on clay: it carries (2 + pi) c, rough or smooth, whatever Poisson's ratio.

#include "tests/verification/mpm_domain/limit_loads/footing.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <ostream>

namespace tremolo::mpm_domain {
namespace {

struct Footing {
  bool rough;
  double cell_size; ///< m
  double poisson;   ///< of the clay

  friend void PrintTo(const Footing& f, std::ostream* out) {
    *out << (f.rough ? "rough" : "smooth") << ", cells of " << f.cell_size << " m, nu " << f.poisson;
  }
};

/// @param load  over (2 + pi) c
bool carries(const Footing& footing, double load) {
  constexpr double cohesion = 20e3;
  Spec spec = test::footing_on_clay(footing.cell_size, load * (2.0 + std::numbers::pi) * cohesion,
                                    footing.rough ? 2e8 : 2e5);
  spec.soils.front().law = test::light_clay(footing.poisson, cohesion);
  return test::carries_its_weight(spec, 15.0);
}

class Prandtl : public testing::TestWithParam<Footing> {};

TEST_P(Prandtl, FootingCarriesTwoPlusPiTimesTheCohesion) {
  EXPECT_TRUE(carries(GetParam(), 0.95));
  EXPECT_FALSE(carries(GetParam(), 1.05));
}

INSTANTIATE_TEST_SUITE_P(Footings, Prandtl,
                         testing::Values(Footing{true, 0.25, 0.3}, Footing{true, 0.2, 0.3},
                                         Footing{true, 1.0 / 6.0, 0.3}, Footing{true, 0.25, 0.495},
                                         Footing{true, 0.2, 0.495}, Footing{true, 1.0 / 6.0, 0.495},
                                         Footing{false, 0.25, 0.3}, Footing{false, 0.2, 0.3},
                                         Footing{false, 1.0 / 6.0, 0.3}, Footing{false, 0.25, 0.495}));

} // namespace
} // namespace tremolo::mpm_domain
