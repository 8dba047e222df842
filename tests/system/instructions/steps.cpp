// Ten steps of dry elastic soil, for test_instructions.py to count.

#include "mpm_domain/step/stepper.hpp"
#include "tests/support/no_traction.hpp"

#include <cmath>
#include <iostream>

namespace {

using namespace tremolo::mpm_domain;

constexpr double side = 48.0; // m, of a square with cells of 1 m

Spec dry_elastic_square() {
  Spec spec;
  spec.box = {0.0, 0.0, side, side};
  spec.cell_size = 1.0;
  spec.soils = {{"soil", tremolo::materials::LinearElastic{{1700.0, 40e6, 0.28}}}};
  spec.regions = {{0, {{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}}}};
  spec.scheme.transfer = Transfer::flip;
  spec.scheme.order = StepOrder::usl;
  return spec;
}

} // namespace

int main() {
  Domain domain(dry_elastic_square());
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      set.vx[k] = 0.01 * std::sin(6.0 * set.y[k] / side);
  Stepper stepper(domain, 0.0, tremolo::test_support::no_traction());
  constexpr int steps = 10;
  for (int step = 0; step < steps; ++step)
    stepper.step();
  std::cout << domain.particle_count() * steps << '\n';
}
