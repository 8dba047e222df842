// Ten steps of the same dry elastic square, by the domain or by the plain loop, for test_instructions.py to
// count.
//
//     instructions_steps domain|plain
//
// Prints how many updates of a particle that is.

#include "mpm_domain/step/stepper.hpp"
#include "tests/cost/mpm_domain/plain_step.hpp"
#include "tests/support/quiet_ground.hpp"

#include <cmath>
#include <iostream>
#include <string_view>

namespace {

using namespace tremolo;
using namespace mpm_domain;

constexpr int cells = 48;         // a side of the square
constexpr double cell_size = 1.0; // m
constexpr int steps = 10;
const materials::Elasticity soil{1700.0, 40e6, 0.28};

/// The scheme of the plain loop: update stress last, FLIP.
Spec dry_elastic_square() {
  constexpr double side = cells * cell_size;
  Spec spec;
  spec.box = {0.0, 0.0, side, side};
  spec.cell_size = cell_size;
  spec.soils = {{"soil", materials::LinearElastic{soil}}};
  spec.regions = {{0, {{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}}}};
  spec.scheme.transfer = Transfer::flip;
  spec.scheme.order = StepOrder::usl;
  return spec;
}

std::size_t step_domain() {
  Domain domain(dry_elastic_square());
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      set.vx[k] = 0.01 * std::sin(6.0 * set.y[k] / domain.spec.box.y_max);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  for (int step = 0; step < steps; ++step)
    stepper.step();
  return domain.particle_count() * steps;
}

std::size_t step_plain() {
  cost::PlainStep plain(cells, cell_size, soil.density, soil.young, soil.poisson);
  const double dt = 0.3 * cell_size / soil.p_wave_speed();
  for (int step = 0; step < steps; ++step)
    plain.step(dt);
  return plain.particles() * steps;
}

} // namespace

int main(int, char** arguments) {
  std::cout << (std::string_view(arguments[1]) == "plain" ? step_plain() : step_domain()) << '\n';
}
