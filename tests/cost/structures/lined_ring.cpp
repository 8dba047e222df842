// A ring of beams against one of solid particles in the same sheared ground: a concrete ring 0.3 m thick
// about an axis of 3 m in dry ground of 200 MPa that sticks to it (tests/support/sheared_ring.hpp; periodic
// sides, 24 m apart, and a surface three radii above its axis). Prints
//
//     ring, cell, through, step, moment, thrust, cpu
//
// its cells (m), cells through its thickness, the time step (s), amplitudes of M and N over those of the
// exact solution in ground without end, and CPU time of a second of simulation (s), of 40 steps. The number
// of the first argument ends the list of solid rings.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/sheared_ring.hpp"
#include "tests/support/structure_scene.hpp"
#include "tests/support/wet_lining.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <vector>

namespace tremolo::cost {
namespace {

using namespace mpm_domain;
using namespace test_support;

constexpr Vector centre{0.13, -10.21};
constexpr double inner = ring_radius - 0.5 * ring_thickness, outer = ring_radius + 0.5 * ring_thickness;
constexpr double young = 2e8, poisson = 0.3, strain = 1e-4;
constexpr double shear = young / (2.0 * (1.0 + poisson));
constexpr double friction = 10.0;
constexpr int cuts = 36;

/// @param level  of the finest cells, 2^-level m
Spec ground(int level) {
  Spec spec = flat_ground(24.0, 20.0, 1.0, {1900.0, young, poisson});
  spec.sides = Sides::periodic;
  spec.threads = 1;
  for (int l = 1; l <= level; ++l) {
    const double half = 4.0 + 0.5 * (level - l);
    spec.refine.push_back({{-half, -10.0 - half, half, -10.0 + half}, l});
  }
  spec.loads = {{.x_min = -12.0, .x_max = 12.0, .shear = shear * strain}};
  return spec;
}

Spec solid(int level) {
  Spec spec = ground(level);
  Structure ring = structure(circle(centre, outer), 2500.0, friction);
  ring.name = "ring";
  ring.hole = circle(centre, inner);
  ring.stiffness = Stiffness{30e9, 0.2};
  spec.structures = {ring};
  Section around{"around", "ring", {}};
  for (int k = 0; k < cuts; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / cuts;
    const Vector out{std::cos(angle), std::sin(angle)};
    around.cuts.push_back({{centre.x + (inner - 0.1) * out.x, centre.y + (inner - 0.1) * out.y},
                           {centre.x + (outer + 0.1) * out.x, centre.y + (outer + 0.1) * out.y}});
  }
  spec.sections = {around};
  return spec;
}

struct Amplitudes {
  double moment = 0.0, thrust = 0.0;

  void add(double share, double angle, const SectionForces& forces) {
    moment += share * std::sin(2.0 * angle) * forces.moment;
    thrust += share * std::sin(2.0 * angle) * forces.axial;
  }
};

Amplitudes amplitudes(const Domain& domain) {
  Amplitudes sums;
  for (const LiningBody& lining : domain.linings.bodies()) {
    const auto count = static_cast<double>(lining.beam().elements().size());
    for (std::size_t e = 0; e < lining.beam().elements().size(); ++e)
      sums.add(2.0 / count, 2.0 * std::numbers::pi * (static_cast<double>(e) + 0.5) / count,
               lining.beam().forces(e));
  }
  for (const BodySection& section : domain.sections.all())
    for (std::size_t k = 0; k < section.cuts.size(); ++k)
      sums.add(2.0 / cuts, 2.0 * std::numbers::pi * static_cast<double>(k) / cuts,
               forces(domain, section, k));
  return sums;
}

void measure(const char* ring, double cell, const Spec& spec) {
  Domain domain(spec);
  const std::vector<StaticStage> stages{LoadSettings{{.ramp = 0.5, .residual = 1e-5, .max_time = 20.0}, 0}};
  std::vector<Amplitudes> before;
  const Reactions reactions = bring_to_rest(domain, {.residual = 1e-5, .max_time = 20.0}, stages,
                                            [&](std::size_t stage, long, double) {
                                              if (stage == 1 && before.empty())
                                                before.push_back(amplitudes(domain));
                                            });
  const Amplitudes after = amplitudes(domain);
  const RingInShear exact(shear, poisson, strain, true);
  replace_constraints(domain, reactions);
  Stepper stepper(domain, 0.0, quiet_ground());
  const std::clock_t begin = std::clock();
  for (int k = 0; k < 40; ++k)
    stepper.step();
  const double cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  fmt::print("{},{:g},{:.2g},{:.3g},{:.4f},{:.4f},{:.4g}\n", ring, cell, ring_thickness / cell,
             stepper.time() / 40.0, (after.moment - before.front().moment) / exact.moment,
             (after.thrust - before.front().thrust) / exact.thrust, cpu / stepper.time());
  std::fflush(stdout);
}

} // namespace
} // namespace tremolo::cost

int main(int argc, char** argv) {
  using namespace tremolo;
  const int finest = argc > 1 ? std::atoi(argv[1]) : 4;
  fmt::print("ring,cell,through,step,moment,thrust,cpu\n");
  for (const int level : {0, 1, 2, 3}) {
    mpm_domain::Spec spec = cost::ground(level);
    spec.linings = {test_support::concrete_lining(cost::centre, cost::friction)};
    cost::measure("beams", std::ldexp(1.0, -level), spec);
  }
  for (int level = 2; level <= finest; ++level)
    cost::measure("solid", std::ldexp(1.0, -level), cost::solid(level));
}
