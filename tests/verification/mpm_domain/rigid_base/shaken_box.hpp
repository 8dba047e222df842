#pragma once

// A box of elastic soil on a rigid base that moves by a Ricker pulse of velocity.

#include "tests/support/box_run.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>

namespace tremolo::test_support {

/// V(t) of the base along an axis, m/s.
struct BasePulse {
  double frequency = 4.0; ///< Hz
  double peak_time = 0.4; ///< s

  double operator()(double time) const {
    const double a = std::pow(std::numbers::pi * frequency * (time - peak_time), 2);
    return 0.1 * (1.0 - 2.0 * a) * std::exp(-a);
  }
};

/// What a run in the frame of the base has shown.
struct ShakenBox {
  double error = 0.0;    ///< relative L2 of the velocity of all particles over the run
  double residual = 0.0; ///< largest residual of the energy ledger over the largest work of inertia
  double base = 0.0;     ///< largest velocity of the base beside V(t), over the peak of V
};

/// Velocity relative to the base (m/s) of a place at a time.
using ExactMotion = std::function<eq6::Vector(double x, double y, double time)>;

/// @param direction  of the base's motion
inline ShakenBox run_shaken_box(const mpm_domain::Spec& spec, const BasePulse& pulse, eq6::Vector direction,
                                const ExactMotion& exact, double end) {
  mpm_domain::Domain domain(spec);
  mpm_domain::Stepper stepper(domain, 0.0, [&](long, double t, auto, std::span<eq6::FreeField> field) {
    for (eq6::FreeField& face : field)
      face.velocity = {pulse(t) * direction.x, pulse(t) * direction.y};
  });
  double difference = 0.0;
  double norm = 0.0;
  double work = 0.0;
  ShakenBox result;
  while (stepper.time() < end) {
    stepper.step();
    result.residual = std::max(result.residual, std::abs(domain.energy.residual()));
    work = std::max(work, std::abs(domain.energy.input));
    const double time = stepper.velocity_time();
    const eq6::Vector base = domain.boundary.base_motion().velocity;
    result.base =
        std::max(result.base,
                 std::hypot(base.x - pulse(time) * direction.x, base.y - pulse(time) * direction.y) / 0.1);
    if (stepper.steps() % 8 != 0)
      continue;
    for (const mpm_domain::Particles& set : domain.sets) {
      // With steps of their own, smaller cells know velocities half of such a step before the end.
      const double share = spec.scheme.subcycle ? set.cell_size / spec.cell_size : 1.0;
      const double of_set = stepper.time() - 0.5 * share * stepper.dt();
      for (std::size_t k = 0; k < set.size(); ++k) {
        const eq6::Vector expected = exact(set.x_initial[k], set.y_initial[k], of_set);
        const eq6::Vector v = mpm_domain::particle_velocity(domain, set, k);
        difference += std::pow(v.x - expected.x, 2) + std::pow(v.y - expected.y, 2);
        norm += expected.x * expected.x + expected.y * expected.y;
      }
    }
  }
  result.error = std::sqrt(difference / norm);
  result.residual /= work;
  return result;
}

} // namespace tremolo::test_support
