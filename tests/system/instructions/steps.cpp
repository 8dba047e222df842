// Some steps for test_instructions.py, test_dispersion.py, test_serial_share.py and test_contact.py to count.
//
//     instructions_steps MODEL
//
// MODEL is a dry elastic square by the `domain` or by the `plain` loop, or with the default scheme and
// `plain` or `reduced` dispersion (`dispersion:plain`), or the slope of cases/slope_oblique with matched
// layers: `uniform`, `graded` or `subcycled`. Prints how many updates of a particle that is. Or it is a block
// on flat ground, whose width and that of the ground follow the name, in cells: `block:8:40`. Then it prints
// how many contact nodes it has met.

#include "mpm_domain/step/stepper.hpp"
#include "tests/cost/mpm_domain/plain_step.hpp"
#include "tests/support/quiet_ground.hpp"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <string_view>

namespace {

using namespace tremolo;
using namespace mpm_domain;

constexpr int cells = 48;         // a side of the square
constexpr double cell_size = 1.0; // m
constexpr int square_steps = 10;
constexpr int slope_steps = 4;
constexpr int block_steps = 12;
const materials::Elasticity soil{1700.0, 40e6, 0.28};

/// The scheme of the plain loop: update stress last, FLIP.
Spec dry_elastic_square(int cells_a_side = cells) {
  const double side = cells_a_side * cell_size;
  Spec spec;
  spec.box = {0.0, 0.0, side, side};
  spec.cell_size = cell_size;
  spec.soils = {{"soil", materials::LinearElastic{soil}}};
  spec.regions = {{0, {{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}}}};
  spec.scheme.transfer = Transfer::flip;
  spec.scheme.order = StepOrder::usl;
  return spec;
}

/// The default scheme, update stress last with remapped velocity and APIC.
Spec with_dispersion(Dispersion dispersion) {
  Spec spec = dry_elastic_square(3 * cells);
  spec.scheme = {.dispersion = dispersion};
  return spec;
}

Spec slope(std::string_view mesh) {
  Spec spec;
  spec.box = {0.0, -20.0, 90.0, 10.0};
  spec.cell_size = mesh == "uniform" ? 0.5 : 1.0;
  if (mesh != "uniform")
    spec.refine = {{{26.0, -8.0, 72.0, 10.0}, 1}, {{34.0, -3.0, 60.0, 10.0}, 2}};
  spec.scheme.subcycle = mesh == "subcycled";
  spec.gravity = 9.81;
  spec.matched_sides = {Side::left, Side::right, Side::base};
  spec.soils = {{"slope", materials::LinearElastic{{1700.0, 40e6, 0.28}}}};
  spec.regions = {{0, {{0.0, -20.0}, {90.0, -20.0}, {90.0, 10.0}, {50.0, 10.0}, {40.0, 0.0}, {0.0, 0.0}}}};
  return spec;
}

std::size_t step_domain(const Spec& spec, int steps) {
  Domain domain(spec);
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      set.vx[k] = 0.01 * std::sin(6.0 * set.y[k] / domain.spec.box.y_max);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  for (int step = 0; step < steps; ++step)
    stepper.step();
  return domain.particle_count() * steps;
}

std::size_t step_block(int block, int ground) {
  const double half = 0.5 * block * cell_size;
  const double side = 0.5 * ground * cell_size;
  Spec spec;
  spec.box = {-side, -0.5 * side, side, 0.0};
  spec.cell_size = cell_size;
  spec.gravity = 9.81;
  spec.soils = {{"soil", materials::LinearElastic{soil}}};
  spec.regions = {{0, {{-side, -0.5 * side}, {side, -0.5 * side}, {side, 0.0}, {-side, 0.0}}}};
  spec.structures = {{.name = "block",
                      .outline = {{-half, 0.0}, {half, 0.0}, {half, 4.0}, {-half, 4.0}},
                      .density = 2000.0,
                      .friction = {0.5},
                      .adhesion = {0.0}}};
  Domain domain(spec);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  std::size_t met = 0;
  for (int step = 0; step < block_steps; ++step) {
    stepper.step();
    met += domain.contact.nodes(0).size();
  }
  return met;
}

std::size_t step_plain() {
  cost::PlainStep plain(cells, cell_size, soil.density, soil.young, soil.poisson);
  const double dt = 0.3 * cell_size / soil.p_wave_speed();
  for (int step = 0; step < square_steps; ++step)
    plain.step(dt);
  return plain.particles() * square_steps;
}

} // namespace

int main(int, char** arguments) {
  const std::string_view model = arguments[1];
  int block = 0;
  int ground = 0;
  if (std::sscanf(arguments[1], "block:%d:%d", &block, &ground) == 2) {
    std::cout << step_block(block, ground) << '\n';
    return 0;
  }
  std::cout << (model == "plain"              ? step_plain()
                : model == "domain"           ? step_domain(dry_elastic_square(), square_steps)
                : model == "dispersion:plain" ? step_domain(with_dispersion(Dispersion::plain), square_steps)
                : model == "dispersion:reduced"
                    ? step_domain(with_dispersion(Dispersion::reduced), square_steps)
                    : step_domain(slope(model), slope_steps))
            << '\n';
}
