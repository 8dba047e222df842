// What a level interface reflects. A lumped chain of cells of size h has the impedance
//
//     Z = rho c sqrt(1 - x^2),      x = omega h/(2c) = sin(k h/2),
//
// lower the coarser it is, so that an interface between cells of h and h/2 reflects, from either side,
//
//     |R| = (sqrt(1 - x^2/4) - sqrt(1 - x^2)) / (sqrt(1 - x^2/4) + sqrt(1 - x^2)),
//
// with the coarse cells' x. The interface of the mesh is to reflect hardly more.

#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain {
namespace {

enum class Body { p, sv };

constexpr double h = 1.0;         // of the coarse cells, m
constexpr double half = 170.0;    // of the strip on either side of the interface at y = 0, m
constexpr double width = 2.0;     // m, and then again
constexpr double envelope = 20.0; // standard deviation of the packet's envelope, m
constexpr double start = 85.0;    // distance of the packet from the interface, m

/// A strip of coarse cells below y = 0 and fine ones above, without sides, whose ends the packet never sees.
Spec strip() {
  Spec spec = test_support::elastic_box(width, 2.0 * half, h);
  spec.box = {0.0, -half, width, half};
  spec.regions = {{0, {{0.0, -half}, {width, -half}, {width, half}, {0.0, half}}}};
  spec.periodic_sides = true;
  spec.threads = 1;
  spec.refine = {{{0.0, 0.0, width, half}, 1}};
  spec.scheme.transfer = Transfer::flip;
  spec.scheme.fraction = 0.3;
  return spec;
}

double wave_speed(const materials::Elasticity& soil, Body wave) {
  return wave == Body::p ? soil.p_wave_speed() : soil.s_wave_speed();
}

/// A packet that travels towards the interface: stress -+ rho c v goes with v.
void send_packet(Domain& domain, Body wave, double wave_number, bool from_below) {
  const double centre = from_below ? -start : start;
  const double direction = from_below ? 1.0 : -1.0;
  for (Particles& p : domain.sets) {
    const materials::Elasticity& soil = materials::elasticity(p.law);
    const double impedance = soil.density * wave_speed(soil, wave);
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double y = p.y[k] - centre;
      const double v = 1e-3 * std::exp(-0.5 * y * y / (envelope * envelope)) * std::cos(wave_number * y);
      const double stress = -direction * impedance * v;
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

/// Kinetic and elastic energy of one direction of motion on one side of the interface, J/m.
double energy(const Domain& domain, Body wave, bool below) {
  double sum = 0.0;
  for (const Particles& p : domain.sets) {
    const materials::Elasticity& soil = materials::elasticity(p.law);
    const double modulus = wave == Body::p ? soil.p_modulus() : soil.shear_modulus();
    for (std::size_t k = 0; k < p.size(); ++k) {
      if ((p.y[k] < 0.0) != below)
        continue;
      const double v = wave == Body::p ? p.vy[k] : p.vx[k];
      const double stress = wave == Body::p ? p.syy[k] : p.sxy[k];
      sum += 0.5 * p.mass[k] * v * v + 0.5 * p.volume[k] * stress * stress / modulus;
    }
  }
  return sum;
}

/// x of the coarse cells, and what comes back over what was sent.
struct Reflection {
  double closed = 0.0;
  double measured = 0.0;
};

Reflection reflection(Body wave, double cells, bool from_below) {
  Domain domain(strip());
  domain.faces.clear();
  const double x = std::numbers::pi / cells;
  const double wave_number = from_below ? 2.0 / h * std::asin(x) : 4.0 / h * std::asin(0.5 * x);
  send_packet(domain, wave, wave_number, from_below);
  const double sent = energy(domain, wave, from_below);
  Stepper stepper(domain, 0.0, [](long, double, auto, auto) {});
  const double speed = wave_speed(materials::elasticity(domain.spec.soils.front().law), wave);
  while (stepper.time() < 2.0 * start / speed)
    stepper.step();
  const double fine = std::sqrt(1.0 - 0.25 * x * x);
  const double coarse = std::sqrt(1.0 - x * x);
  return {(fine - coarse) / (fine + coarse), std::sqrt(energy(domain, wave, from_below) / sent)};
}

class LevelInterface : public testing::TestWithParam<std::tuple<Body, bool>> {};

TEST_P(LevelInterface, ReflectsNoMoreThanTheImpedanceOfItsCells) {
  const auto [wave, from_below] = GetParam();
  for (const double cells : {10.0, 15.0}) {
    const Reflection r = reflection(wave, cells, from_below);
    EXPECT_LT(r.measured, 1.1 * r.closed) << cells << " coarse cells a wave length";
    EXPECT_GT(r.measured, 0.3 * r.closed) << "nothing has come back: the packet was not where it should be";
  }
}

INSTANTIATE_TEST_SUITE_P(Waves, LevelInterface,
                         testing::Combine(testing::Values(Body::p, Body::sv), testing::Bool()),
                         [](const auto& of) {
                           return std::string(std::get<0>(of.param) == Body::p ? "P" : "Sv") +
                                  (std::get<1>(of.param) ? "FromTheCoarseSide" : "FromTheFineSide");
                         });

} // namespace
} // namespace tremolo::mpm_domain
