// Prandtl's strip footing on clay: it carries (2 + pi) c, rough or smooth, whatever Poisson's
// ratio. The load is the weight of a block as wide as the footing: stiff and bonded to the clay, a rough
// rigid footing, or soft as a liquid in shear, a uniform pressure.

#include "tests/verification/mpm_domain/limit_loads/static_limit.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <ostream>

namespace tremolo::mpm_domain {
namespace {

constexpr double width = 4.0; // of the footing, m
constexpr double cohesion = 20e3;

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
  constexpr double side = 6.0, depth = 4.0, block = 1.0; // m
  constexpr double right = 2.0 * side + width;
  const double pressure = load * (2.0 + std::numbers::pi) * cohesion;
  Spec spec;
  spec.box = {0.0, -depth, right, block};
  spec.cell_size = footing.cell_size;
  spec.gravity = test::gravity;
  constexpr double light = 500.0; // kg/m3; the weight of clay without friction is no help to a footing on it
  const double stiffness = footing.rough ? 2e8 : 2e5;
  spec.soils = {{"clay", test::perfectly_plastic({light, 20e6, footing.poisson}, cohesion, 0.0)},
                {"block", materials::LinearElastic{{pressure / (test::gravity * block), stiffness, 0.0}}}};
  spec.regions = {{0, {{0.0, -depth}, {right, -depth}, {right, 0.0}, {0.0, 0.0}}},
                  {1, {{side, 0.0}, {side + width, 0.0}, {side + width, block}, {side, block}}}};
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
                                         Footing{false, 0.25, 0.3}, Footing{false, 0.2, 0.3},
                                         Footing{false, 1.0 / 6.0, 0.3}, Footing{false, 0.25, 0.495}));

} // namespace
} // namespace tremolo::mpm_domain
