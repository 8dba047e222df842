// Excess pore pressure under a load leaves through the top (Terzaghi 1943, Theoretical Soil Mechanics, ch.
// 13; verification C1). Water is compressible here, so the load is shared by Q/(M + Q) at the start and c_v
// holds the storage of the water. A pressure is the mean of its cell, so cells are compared.

#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "tests/verification/mpm_domain/water/saturated_column.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

namespace tremolo::mpm_domain {
namespace {

/// p/q at a height z above the impervious base of a column of height H.
double terzaghi(double z, double height, double time_factor) {
  double sum = 0.0;
  for (int m = 0; m < 200; ++m) {
    const double k = std::numbers::pi * (2.0 * m + 1.0) / 2.0;
    sum += 2.0 / k * std::sin(k * (height - z) / height) * std::exp(-k * k * time_factor);
  }
  return sum;
}

struct Choice {
  Transfer transfer;
  StepOrder order;
};

class Consolidation : public testing::TestWithParam<Choice> {
protected:
  test_support::SaturatedColumn column() const {
    test_support::SaturatedColumn column;
    column.pores.permeability = 2e-4;
    column.fluid.bulk_modulus = 2.2e8;
    column.scheme.transfer = GetParam().transfer;
    column.scheme.order = GetParam().order;
    return column;
  }
};

/// Root mean square of the error of p over all cells, over the load that water bears at the start.
double error_of(const Domain& domain, const test_support::SaturatedColumn& column, double load,
                double time_factor) {
  double error = 0.0;
  int count = 0;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k, ++count) {
      const double centre = (std::floor(set.y_initial[k] / column.cell) + 0.5) * column.cell;
      const double p = excess_pressure(set, k) / load;
      error += std::pow(p - terzaghi(centre + column.height, column.height, time_factor), 2);
    }
  return std::sqrt(error / count);
}

TEST_P(Consolidation, FollowsTerzaghi) {
  const test_support::SaturatedColumn given = column();
  const auto domain = given.at_rest();
  const double q = materials::pore_stiffness(given.pores, given.fluid);
  const double load = given.load * q / (q + given.p_modulus);
  test_support::load_water(*domain, [&](double) { return load; });
  Stepper stepper(*domain, 0.0, test_support::at_rest_source());
  const double c_v =
      materials::consolidation_coefficient(given.p_modulus, given.pores, given.fluid, domain->spec.gravity);
  const double height2 = given.height * given.height;
  for (const auto& [time_factor, allowed] : {std::tuple{0.05, 1.5e-3}, {0.2, 7e-4}, {0.5, 5e-4}}) {
    while (stepper.time() < time_factor * height2 / c_v)
      stepper.step();
    EXPECT_LT(error_of(*domain, given, load, time_factor), allowed) << "time factor " << time_factor;
  }
  // Water that has left was lifted by weight that sank; what it lost to the grains is all that has gone.
  const EnergyLedger& energy = domain->energy;
  EXPECT_GT(energy.drag, 0.3 * energy.gravity);
  EXPECT_LT(std::abs(energy.residual()), 1e-3 * energy.gravity);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Consolidation,
                         testing::Values(Choice{Transfer::apic, StepOrder::musl},
                                         Choice{Transfer::flip, StepOrder::musl},
                                         Choice{Transfer::apic, StepOrder::usl}),
                         [](const auto& choice) {
                           return std::string(choice.param.transfer == Transfer::apic ? "Apic" : "Flip") +
                                  (choice.param.order == StepOrder::musl ? "Musl" : "Usl");
                         });

} // namespace
} // namespace tremolo::mpm_domain
