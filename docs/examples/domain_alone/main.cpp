// shaken_box: tremolo's domain in a program of your own, without processes, case files or output. A box of
// soil is shaken by a vertical SV pulse, whose closed form is the free field of every face:
//
//     v_x = V [f(t - t0 - y/c) + f(t - t0 + y/c)],    s_xy = rho c V [-f(t - t0 - y/c) + f(t - t0 + y/c)],
//
// the pulse that comes up and what the free surface at y = 0 reflects. The surface moves with 2 V.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/step/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>

using namespace tremolo;

namespace {

const materials::Elasticity soil{.density = 1700.0, .young = 40e6, .poisson = 0.28};
constexpr double pulse_velocity = 0.1; // V, m/s

/// Ricker's pulse of 3 Hz, 1 at t = 0.5 s
double pulse(double t) {
  const double a = std::pow(3.0 * std::numbers::pi * (t - 0.5), 2);
  return (1.0 - 2.0 * a) * std::exp(-a);
}

eq6::FreeField free_field(double y, double t) {
  const double c = soil.s_wave_speed();
  const double up = pulse_velocity * pulse(t - y / c);
  const double down = pulse_velocity * pulse(t + y / c);
  return {.velocity = {up + down, 0.0}, .stress = {.xy = soil.density * c * (down - up)}};
}

mpm_domain::Spec box_of_soil() {
  mpm_domain::Spec spec;
  spec.box = {.x_min = 0.0, .y_min = -20.0, .x_max = 40.0, .y_max = 0.0}; // m
  spec.cell_size = 1.0;
  spec.soils = {{"soil", materials::LinearElastic{soil}}};
  spec.regions = {{0, {{0.0, -20.0}, {40.0, -20.0}, {40.0, 0.0}, {0.0, 0.0}}}};
  return spec;
}

} // namespace

int main() {
  mpm_domain::Domain domain(box_of_soil());
  // Once a step: the velocities of the faces go out, the free field comes in.
  mpm_domain::Stepper stepper(domain, 0.0,
                              [&](long, double t, std::span<const Vector>, std::span<eq6::FreeField> field) {
                                for (std::size_t f = 0; f < field.size(); ++f)
                                  field[f] = free_field(domain.boundary.faces()[f].position.y, t);
                              });
  double largest = 0.0;
  while (stepper.time() < 1.5) {
    stepper.step();
    for (const mpm_domain::Particles& particles : domain.sets)
      for (std::size_t k = 0; k < particles.size(); ++k)
        if (particles.y_initial[k] > -0.5) // the row at the surface
          largest = std::max(largest, particles.vx[k]);
  }
  std::printf("%ld steps of %.4f s; the surface moves with %.3f times the incident wave\n", stepper.steps(),
              stepper.time() / static_cast<double>(stepper.steps()), largest / pulse_velocity);
  std::printf("energy that the ledger leaves unaccounted for: %.1e of the input\n",
              std::abs(domain.energy.residual()) / domain.energy.input);
  return std::abs(largest / pulse_velocity - 2.0) < 0.02 ? 0 : 1;
}
