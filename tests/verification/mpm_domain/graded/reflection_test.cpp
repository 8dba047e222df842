// What a level interface reflects. A lumped chain of cells of size h has the impedance
//
//     Z = rho c sqrt(1 - x^2),      x = omega h/(2c) = sin(k h/2),
//
// lower the coarser it is, so that an interface between cells of h and h/2 reflects, from either side,
//
//     |R| = (sqrt(1 - x^2/4) - sqrt(1 - x^2)) / (sqrt(1 - x^2/4) + sqrt(1 - x^2)),
//
// with the coarse cells' x. That is what the mesh alone does (interface_reflection_test.cpp); here packets
// cross an interface in the domain's own steps, transfers and all.

#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/verification/mpm_domain/graded/level_interface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain {
namespace {

constexpr double half = 170.0;    // of the strip on either side of the interface at y = 0, m
constexpr double envelope = 20.0; // standard deviation of the packet's envelope, m
constexpr double start = 85.0;    // distance of the packet from the interface, m

Spec strip(Transfer transfer, bool is_fine_below) {
  Spec spec = level_interface(half, is_fine_below);
  spec.scheme.transfer = transfer;
  spec.scheme.fraction = 0.3;
  return spec;
}

double wave_speed(const materials::Elasticity& soil, Body wave) {
  return wave == Body::p ? soil.p_wave_speed() : soil.s_wave_speed();
}

/// A packet that travels up to the interface: stress -rho c v goes with v. On the grid it is not quite that,
/// and a small part goes down, where dashpots take it up.
void send_packet(Domain& domain, Body wave, double wave_number) {
  for (Particles& p : domain.sets) {
    const materials::Elasticity& soil = materials::elasticity(p.law);
    const double impedance = soil.density * wave_speed(soil, wave);
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double y = p.y[k] + start;
      const double v = 1e-3 * std::exp(-0.5 * y * y / (envelope * envelope)) * std::cos(wave_number * y);
      const double stress = -impedance * v;
      if (wave == Body::sv) {
        p.vx[k] = v;
        p.sxy[k] = stress;
      } else {
        p.vy[k] = v;
        p.syy[k] = stress;
        p.sxx[k] = p.szz[k] = soil.lame() / soil.p_modulus() * stress;
      }
    }
  }
}

/// Kinetic energy of the grid below the interface, J/m: what particles have that the grid does not see, FLIP
/// keeps where it was.
double energy_below(const Domain& domain) {
  const Grid& grid = domain.grid;
  double sum = 0.0;
  for (int level = 0; level < domain.lattice_count(); ++level) {
    const Lattice& lattice = domain.lattice(level);
    for (int j = 0; j < lattice.ny; ++j)
      for (int i = 0; i < lattice.nx && lattice.y0 + j * lattice.h < -1e-6; ++i) {
        const std::size_t n = lattice.index(i, j);
        sum += 0.5 * grid.mass[n] *
               (grid.vx_before[n] * grid.vx_before[n] + grid.vy_before[n] * grid.vy_before[n]);
      }
  }
  return sum;
}

/// By the impedances, and what comes back over what was sent.
struct Reflection {
  double closed = 0.0;
  double measured = 0.0;
};

Reflection reflection(Transfer transfer, Body wave, double cells, bool is_fine_below) {
  Domain domain(strip(transfer, is_fine_below));
  const double x = std::numbers::pi / cells;
  send_packet(domain, wave, is_fine_below ? 4.0 / h * std::asin(0.5 * x) : 2.0 / h * std::asin(x));
  scatter(domain, ScatterPart::motion);
  grid_velocities(domain, domain.soil_rows);
  const double sent = energy_below(domain);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  const double speed = wave_speed(materials::elasticity(domain.spec.soils.front().law), wave);
  while (stepper.time() < 2.0 * start / speed)
    stepper.step();
  return {reflected_by_impedances(cells), std::sqrt(energy_below(domain) / sent)};
}

class LevelInterfaceWithApic : public testing::TestWithParam<Arrival> {};

TEST_P(LevelInterfaceWithApic, ReflectsNoMoreThanTheImpedanceOfItsCells) {
  const auto [wave, is_fine_below] = GetParam();
  for (const double cells : {10.0, 15.0}) {
    const Reflection r = reflection(Transfer::apic, wave, cells, is_fine_below);
    EXPECT_LT(r.measured, 1.1 * r.closed) << cells << " coarse cells a wave length";
    EXPECT_GT(r.measured, 0.9 * r.closed) << cells << " coarse cells a wave length";
  }
}

/// FLIP's particles take the change of velocity through weights that spread over two cells, and the grid's
/// velocity through them again: that slows waves on coarse cells more than on fine ones, and the interface is
/// steeper by it.
TEST(AcceptanceLevelInterface, WithFlipReflectsTwiceAsMuch) {
  const Reflection r = reflection(Transfer::flip, Body::sv, 10.0, false);
  EXPECT_LT(r.measured, 2.1 * r.closed);
  EXPECT_GT(r.measured, 1.5 * r.closed);
}

INSTANTIATE_TEST_SUITE_P(Waves, LevelInterfaceWithApic, every_arrival(), name_of_arrival);

} // namespace
} // namespace tremolo::mpm_domain
