// A plane shear wave in saturated elastic soil, aslant to the cells: water that cannot leave resists every
// change of volume, and what the cells cannot shear without such a change would make the wave too fast. Its
// speed is sqrt(G/rho), rho of grains and water together.
//
// The motion is v = curl psi, psi = cos(k.x) e^(-(y - y_0)^2/2 L^2), in a box as wide as the wave is long
// along x. Each component of such a packet oscillates by itself, so the amplitude along exp(-i k.x) goes like
// cos(w t) until the ends of the packet reach those of the box. w follows from its second zero.
//
// A drained soil under water shears as a dry one of its density.

#include "tests/verification/mpm_domain/water/saturated_column.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace tremolo::mpm_domain {
namespace {

constexpr double cell = 1.0;                                   // m
constexpr materials::Elasticity skeleton = {1990.0, 8e7, 0.3}; // Q/G = 180

struct Packet {
  double kx, ky; ///< 1/m
  double middle; ///< y_0, m
  double length; ///< L, m

  Vector velocity(double x, double y) const {
    const double s = (y - middle) / length;
    const double envelope = std::exp(-0.5 * s * s);
    const double phase = kx * x + ky * (y - middle);
    return {(-ky * std::sin(phase) - s / length * std::cos(phase)) * envelope,
            kx * std::sin(phase) * envelope};
  }
  /// Along the shear wave of k, of a velocity v at (x, y).
  std::complex<double> component(double x, double y, Vector v) const {
    return (ky * v.x - kx * v.y) * std::polar(1.0, -(kx * x + ky * (y - middle)));
  }
};

struct Wave {
  materials::Drainage drainage = materials::Drainage::coupled;
  Transfer transfer = Transfer::apic;
  double steepness = 1.0; ///< k_y/k_x; 0: the wave runs straight up
  int cells = 14;         ///< along x from crest to crest, or along y if it runs up
};

Spec spec_of(const Wave& wave, int cells_wide, int cells_high) {
  Spec spec;
  const double width = cell * cells_wide, height = cell * cells_high;
  spec.box = {0.0, -height, width, 0.0};
  spec.cell_size = cell;
  spec.gravity = 9.81;
  spec.sides = Sides::periodic;
  spec.scheme.transfer = wave.transfer;
  spec.scheme.dt = 1.7e-4; // s, half of what saturated soil allows
  spec.water = {0.0, {}};
  Soil soil{.name = "soil", .law = materials::LinearElastic{skeleton}};
  soil.pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-9, .drainage = wave.drainage};
  spec.soils = {soil};
  spec.regions = {{0, {{0.0, -height}, {width, -height}, {width, 0.0}, {0.0, 0.0}}}};
  return spec;
}

/// Speed over sqrt(G/rho).
double measured_speed(const Wave& wave) {
  constexpr int high = 96;
  const bool up = wave.steepness == 0.0;
  const double along = 2.0 * std::numbers::pi / (wave.cells * cell);
  const Packet packet{up ? 0.0 : along, up ? along : wave.steepness * along, -0.5 * high * cell, 12.0 * cell};
  const double number = std::hypot(packet.kx, packet.ky);
  const int wide = up ? 1 : wave.cells;
  Domain domain(spec_of(wave, wide, high));
  replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Vector v = packet.velocity(set.x[k], set.y[k]);
      set.vx[k] = 1e-3 * v.x;
      set.vy[k] = 1e-3 * v.y;
      if (set.traits.flowing) {
        set.wx[k] = set.vx[k];
        set.wy[k] = set.vy[k];
      }
    }
  Stepper stepper(domain, 0.0, test_support::at_rest_source());
  const auto amplitude = [&] {
    std::complex<double> sum;
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        sum += packet.component(set.x_initial[k], set.y_initial[k], {set.vx[k], set.vy[k]});
    return sum;
  };
  const std::complex<double> first = amplitude();
  const double exact = std::sqrt(skeleton.shear_modulus() / skeleton.density);
  // Velocities given at time 0 belong to half a step before: they oscillate about that moment.
  const double start = -0.5 * stepper.dt();
  double before = 1.0;
  double zero = 0.0;
  int zeros = 0;
  constexpr int last = 2; // the zero at 3/4 of a period
  while (zeros < last && stepper.time() < 2.0 * 2.0 * std::numbers::pi / (number * exact)) {
    stepper.step();
    const double now = (amplitude() / first).real();
    if ((now > 0.0) != (before > 0.0)) {
      ++zeros;
      zero = stepper.velocity_time() - stepper.dt() * now / (now - before) - start;
    }
    before = now;
  }
  const double frequency = (last - 0.5) * std::numbers::pi / zero;
  return frequency / number / exact;
}

using enum materials::Drainage;

TEST(SaturatedShearWave, RunsAtItsSpeed) {
  // 9.9 cells a wave.
  EXPECT_NEAR(measured_speed({.drainage = coupled}), 1.0, 0.02) << "at 45 degrees";
  EXPECT_NEAR(measured_speed({.drainage = undrained}), 1.0, 0.02) << "at 45 degrees, locked";
  EXPECT_NEAR(measured_speed({.drainage = coupled, .steepness = 0.5, .cells = 11}), 1.0, 0.02)
      << "at 27 degrees";
  EXPECT_NEAR(measured_speed({.drainage = coupled, .steepness = 0.0, .cells = 10}), 1.0, 0.02)
      << "straight up";
}

/// What the cells do to a wave that changes no volume they do with water and without.
TEST(SaturatedShearWave, WaterAddsNoDispersion) {
  for (const Transfer transfer : {Transfer::apic, Transfer::flip}) {
    const double aslant = measured_speed({.drainage = drained, .transfer = transfer});
    EXPECT_NEAR(measured_speed({.drainage = coupled, .transfer = transfer}), aslant, 0.01);
    const double up =
        measured_speed({.drainage = drained, .transfer = transfer, .steepness = 0.0, .cells = 10});
    EXPECT_NEAR(measured_speed({.drainage = coupled, .transfer = transfer, .steepness = 0.0, .cells = 10}),
                up, 1e-4);
  }
}

TEST(DrainedSoil, ShearsWithTheMassOfItsWater) {
  for (const double steepness : {0.0, 1.0}) {
    EXPECT_NEAR(
        measured_speed({.drainage = drained, .steepness = steepness, .cells = steepness > 0.0 ? 28 : 20}),
        1.0, 0.01);
  }
}

/// Stress at rest is that of the buoyant weight, and motion that of dry soil of the saturated density under
/// the buoyant gravity.
TEST(DrainedSoil, IsDrySoilThatWeighsLess) {
  const Wave wave{.drainage = drained};
  const Spec wet = spec_of(wave, 14, 24);
  Spec dry = wet;
  dry.water.reset();
  dry.soils.front().pores.reset();
  const materials::PoreSpace& pores = *wet.soils.front().pores;
  const double share = materials::buoyant_density(pores, {}) / materials::saturated_density(pores, {});
  dry.gravity *= share;
  std::vector<std::unique_ptr<Domain>> domains;
  for (const Spec& spec : {wet, dry}) {
    Domain& domain = *domains.emplace_back(std::make_unique<Domain>(spec));
    replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
    const double buoyant = share * materials::saturated_density(pores, {}) * wet.gravity;
    for (Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        EXPECT_NEAR(set.syy[k], buoyant * set.y[k], 1e-9 * buoyant * 24.0 * cell);
        set.vx[k] = 1e-2 * std::sin(3.0 * set.x[k] + set.y[k]);
        set.vy[k] = 1e-2 * std::cos(set.x[k] - 2.0 * set.y[k]);
      }
    Stepper stepper(domain, 0.0, test_support::at_rest_source());
    for (int step = 0; step < 500; ++step)
      stepper.step();
  }
  const auto particles = [](const Domain& domain) -> const Particles& {
    return *std::ranges::find_if(domain.sets, [](const Particles& set) { return set.size() > 0; });
  };
  const Particles& a = particles(*domains[0]);
  const Particles& b = particles(*domains[1]);
  ASSERT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    largest = std::max({largest, std::abs(b.vx[k]), std::abs(b.vy[k])});
  EXPECT_GT(largest, 1e-4);
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_NEAR(a.vx[k], b.vx[k], 1e-9 * largest);
    EXPECT_NEAR(a.vy[k], b.vy[k], 1e-9 * largest);
  }
}

} // namespace
} // namespace tremolo::mpm_domain
