// Springs beside the dashpots over a long time: they are symplectic, and their lag takes up energy only.

#include "tests/support/box_models.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/hard_case.hpp"
#include "tests/support/particle_energy.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <random>

namespace tremolo {
namespace {

using namespace test_support;

struct Stiffness {
  double across;
  double along;
  bool lags = false; ///< at the base

  friend void PrintTo(const Stiffness& a, std::ostream* out) {
    *out << "a = " << a.across << ", " << a.along << (a.lags ? ", behind a lag at the base" : "");
  }
};

/// Energy of the particles of a box of 40 by 20 m, whose start is random velocities, after some steps at 0.95
/// of the critical one, over that at the start.
double energy_left(const Stiffness& a, long steps) {
  mpm_domain::Spec spec = elastic_box(40.0, 20.0, 2.0);
  spec.threads = 1;
  spec.scheme.fraction = 0.95;
  add_springs(spec, a.across, a.along, {20.0, 0.0}, a.lags);
  mpm_domain::Domain domain(spec);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> speed(-1.0, 1.0);
  for (mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      set.vx[k] = speed(random);
      set.vy[k] = speed(random);
    }
  const double start = particle_energy(domain);
  mpm_domain::Stepper stepper(domain, 0.0, quiet_ground());
  while (stepper.steps() < steps)
    stepper.step();
  return (kinetic_energy(domain) + energy_of_springs(domain)) / start;
}

class SpringsBesideDashpots : public testing::TestWithParam<Stiffness> {};

TEST_P(SpringsBesideDashpots, TakeUpRandomMotion) {
  bounded("energy after 1e4 steps over the start, " + testing::PrintToString(GetParam()),
          energy_left(GetParam(), 10000), 1e-5);
}

TEST_P(SpringsBesideDashpots, AcceptanceAreQuietAfterAHundredThousandSteps) {
  bounded("energy after 1e5 steps over the start, " + testing::PrintToString(GetParam()),
          energy_left(GetParam(), 100000), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Stiffnesses, SpringsBesideDashpots,
                         testing::Values(Stiffness{1.0, 0.5}, Stiffness{2.0, 1.0},
                                         Stiffness{0.5, 0.25, true}));

} // namespace
} // namespace tremolo
