#pragma once

// A shear pulse in an elastic column whose wavelength at the peak of the spectrum is 1 m, and the ends of the
// column.

#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "tests/support/plane_pulse.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace tremolo::test_support {

/// A column of length 8 or more, and a pulse that meets one of its ends.
struct PulseColumn {
  mpm_domain::Domain domain;
  mpm_domain::Stepper stepper;
  double c, density;

  PulseColumn(double cells, double height, mpm_domain::Dispersion dispersion)
      : PulseColumn(spec(cells, height, dispersion)) {}
  explicit PulseColumn(const mpm_domain::Spec& of)
      : domain(of), stepper(domain, 0.0, moving_ground({})), c(PlanePulse{}.ground.s_wave_speed()),
        density(PlanePulse{}.ground.density) {}

  static mpm_domain::Spec spec(double cells, double height, mpm_domain::Dispersion dispersion) {
    const PlanePulse pulse{.wavelength = 1.0};
    mpm_domain::Spec spec = ground_of(pulse, {1.0 / cells, 1.0 / cells, 0.0, 0.0}, dispersion);
    spec.box.y_max = height;
    spec.regions.front().polygon = {{0.0, 0.0}, {1.0 / cells, 0.0}, {1.0 / cells, height}, {0.0, height}};
    return spec;
  }

  static double ricker(double s) {
    const double a = std::pow(std::numbers::pi * s, 2);
    return 1e-4 * (1.0 - 2.0 * a) * std::exp(-a);
  }

  /// @param way  +1 up, -1 down
  void lay(double from, double way) {
    mpm_domain::Grid& grid = domain.grid;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        grid.vx_after[grid.index(i, j)] =
            ricker(grid.y0 + j * grid.h - from - way * c * stepper.velocity_time());
    gather(domain, 1.0, {.velocity = true, .sharp = domain.is_sharp()});
    for (mpm_domain::Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        set.sxy[k] = -way * density * c * ricker(set.y[k] - from);
  }

  /// sqrt of the sum of squares of v - exact
  double distance(const std::function<double(double)>& exact) const {
    double sum = 0.0;
    for (const mpm_domain::Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        sum += std::pow(particle_velocity(domain, set, k).x - exact(set.y[k]), 2);
    return std::sqrt(sum);
  }

  /// sqrt of the sum of squares of v
  double size() const {
    return distance([](double) { return 0.0; });
  }

  void run_to(double time) {
    while (stepper.time() < time)
      stepper.step();
  }
};

/// What the base sends back of a pulse that leaves through it.
inline double left_behind(double cells, mpm_domain::Dispersion dispersion) {
  PulseColumn column(cells, 12.0, dispersion);
  column.lay(3.0, -1.0);
  column.stepper.step();
  const double before = column.size();
  column.run_to(6.0 / column.c);
  return column.size() / before;
}

} // namespace tremolo::test_support
