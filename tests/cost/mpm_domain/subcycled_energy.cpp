// What happens to energy where levels take steps of their own: smooth waves in a periodic strip with free
// ends, cells of 1, 0.5 and 0.25 m, no dashpots. Kinetic and elastic energy of the particles over that at the
// start, at four times, with the same step for all and with sub-cycling. Prints CSV.

#include "tests/support/box_run.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/particle_energy.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace {

using namespace tremolo;
using namespace mpm_domain;

constexpr int levels = 2;
constexpr double width = 2.0;    // m
constexpr double depth = 16.0;   // m
constexpr double end_time = 1.5; // s
constexpr int samples = 4;

Spec strip(double fraction, bool subcycle) {
  Spec spec = test_support::elastic_box(width, depth, 1.0);
  spec.threads = 1;
  spec.sides = mpm_domain::Sides::periodic;
  spec.refine = {{{0.0, -4.0, width, 0.0}, levels - 1}, {{0.0, -1.0, width, 0.0}, levels}};
  spec.scheme.fraction = fraction;
  spec.scheme.subcycle = subcycle;
  return spec;
}

/// Waves of 3 and 6 m; the free ends stand between rows of nodes.
void set_off(Domain& domain) {
  for (Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      p.vx[k] = 1e-3 * std::cos(p.y[k]);
      p.vy[k] = 1e-3 * std::sin(2.0 * p.y[k]);
      p.y[k] -= 0.031;
    }
  sort_particles(domain);
}

void print(double fraction, bool subcycle) {
  Domain domain(strip(fraction, subcycle));
  set_off(domain);
  const double start = test_support::particle_energy(domain);
  Stepper stepper(domain, 0.0, test_support::no_traction(domain));
  fmt::print("{},{}", fraction, subcycle ? "own" : "same");
  for (int sample = 1; sample <= samples; ++sample) {
    while (stepper.time() < end_time * sample / samples)
      stepper.step();
    fmt::print(",{:.3f}", test_support::particle_energy(domain) / start);
  }
  fmt::print("\n");
  std::fflush(stdout);
}

} // namespace

int main() {
  fmt::print("fraction,steps");
  for (int sample = 1; sample <= samples; ++sample)
    fmt::print(",at {:.3g} s", end_time * sample / samples);
  fmt::print("\n");
  for (const double fraction : {0.1, 0.5, 0.9})
    for (const bool subcycle : {false, true})
      print(fraction, subcycle);
}
