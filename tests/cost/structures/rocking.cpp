// A rocking block, rigid or elastic, with gaps at which contact opens and closes. Prints
//
//     varied, value, half_cycle, restitution, lift, steps, cpu
//
// what is varied and its value (Pa, or cells), half a cycle over Housner's, restitution less Housner's, and
// for gaps the lift of a tunnel in liquefied soil over that of the heavy fluid; steps and CPU time (s) of 2.1
// s.

#include "tests/support/liquefied_tunnel.hpp"
#include "tests/support/rocking_block.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <ctime>
#include <string>

namespace tremolo::cost {
namespace {

using namespace mpm_domain;
using namespace test_support;

void rock(const std::string& varied, double value, Spec spec) {
  spec.threads = 1;
  RockingBlock block(spec);
  const std::clock_t begin = std::clock();
  block.run();
  const double cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  const bool rocked = block.peaks.size() >= 2;
  Spec ground = saturated_flat_ground(20.0, 12.0, 0.5, materials::Drainage::undrained, 1e7);
  ground.gaps = spec.gaps;
  fmt::print(
      "{},{:g},{:.5g},{:.4g},{:.4g},{},{:.4g}\n", varied, value, rocked ? block.half_cycle_over_exact() : 0.0,
      rocked ? block.measured_restitution() - RockingBlock::restitution : -1.0,
      tunnel_forces(ground, 0.13).total_lift() / TunnelForces::of_fluid, block.scene.stepper.steps(), cpu);
  std::fflush(stdout);
}

void vary() {
  rock("rigid", 0.0, RockingBlock::spec());
  for (const double young : {2e7, 5e7, 1e8, 2e8, 5e8, 1e9, 4e9, 1.6e10}) {
    Spec spec = RockingBlock::spec();
    spec.structures.front().stiffness = Stiffness{young, 0.2};
    rock("young", young, spec);
  }
  for (const double gap : {0.005, 0.02, 0.05, 0.1, 0.25, 0.5, 1.0}) {
    Spec spec = RockingBlock::spec();
    spec.gaps.opening = spec.gaps.opening_dry = gap;
    rock("opening", gap, spec);
  }
  for (const double gap : {0.0, 0.002, 0.01, 0.03, 0.1, 0.25}) {
    Spec spec = RockingBlock::spec();
    spec.gaps.closing = gap;
    rock("closing", gap, spec);
  }
}

} // namespace
} // namespace tremolo::cost

int main() {
  fmt::print("varied,value,half_cycle,restitution,lift,steps,cpu\n");
  tremolo::cost::vary();
}
