#pragma once

// A manufactured solution after Wallstedt and Guilkey (2008): a free square block of side L around the
// origin, Poisson's ratio zero, forced by a body acceleration b so that it moves exactly as
//
//     u_x = A sin(pi X/L) sin(omega t),   u_y = -A sin(pi Y/L) sin(omega t),   omega = pi/L sqrt(M/rho0).
//
// Stretches F_ii = 1 + du_i/dX_i lie along the axes, nothing turns, and the rate law of linear elasticity
// integrates to sigma_ii = M ln F_ii, which vanishes at the free faces X, Y = +-L/2. There
//
//     b_i = d2u_i/dt2 - J/rho0 dsigma_ii/dX_i / F_ii = -omega2 u_i + (J M/rho0) (pi/L)2 u_i / F_ii2,
//
// nothing to first order in A: a small amplitude is a standing wave. Small amplitudes show the scheme's
// dispersion, large ones what the boxes of the particles lose when they no longer tile the soil.

#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "tests/support/affine_velocity.hpp"
#include "tests/support/no_traction.hpp"

#include <cmath>
#include <numbers>

namespace tremolo::test_support {

class ManufacturedBlock {
public:
  /// @param amplitude  A/L
  /// @param cells      along the block, L/h
  ManufacturedBlock(double amplitude, int cells, int particles_per_cell, const mpm_domain::Scheme& scheme,
                    mpm_domain::ParticleBoxes boxes = mpm_domain::ParticleBoxes::fixed)
      : amplitude_(amplitude), domain_(spec(cells, particles_per_cell, scheme, boxes)),
        stepper_(released(), 0.0, no_traction(domain_)) {}

  double period() const { return 2.0 * std::numbers::pi / omega; }
  double time() const { return stepper_.time(); }

  /// One step. The body acceleration at its beginning takes velocities over the whole of it, as leapfrog does
  /// with forces. (With stress updated first the strain sees it half a step too soon: for small amplitudes
  /// only, where it vanishes.)
  void step() {
    for (mpm_domain::Particles& p : domain_.sets)
      for (std::size_t k = 0; k < p.size(); ++k) {
        p.vx[k] += stepper_.dt() * body_acceleration(p.x_initial[k], p.y_initial[k], 1.0);
        p.vy[k] += stepper_.dt() * body_acceleration(p.y_initial[k], p.x_initial[k], -1.0);
      }
    stepper_.step();
  }

  /// One step without the body acceleration: another motion, for guards.
  void step_unforced() { stepper_.step(); }

  /// Root mean square of the error of displacement over the particles, over A.
  double displacement_error() const {
    double error2 = 0.0;
    for (const mpm_domain::Particles& p : domain_.sets)
      for (std::size_t k = 0; k < p.size(); ++k) {
        const double ux = displacement(p.x_initial[k], 1.0);
        const double uy = displacement(p.y_initial[k], -1.0);
        error2 += std::pow(p.x[k] - p.x_initial[k] - ux, 2) + std::pow(p.y[k] - p.y_initial[k] - uy, 2);
      }
    return std::sqrt(error2 / static_cast<double>(particles())) / amplitude_;
  }

  std::size_t particles() const { return domain_.particle_count(); }

private:
  static constexpr double density = 1000.0; // kg/m3
  static constexpr double young = 1e7;      // Pa; with Poisson's ratio zero also M
  static constexpr double side = 1.0;       // L, m
  static constexpr double wave_number = std::numbers::pi / side;
  inline static const double omega = wave_number * std::sqrt(young / density);

  static mpm_domain::Spec spec(int cells, int particles_per_cell, const mpm_domain::Scheme& scheme,
                               mpm_domain::ParticleBoxes boxes) {
    mpm_domain::Spec spec;
    spec.box = {-side, -side, side, side};
    spec.cell_size = side / cells;
    spec.particles_per_cell = particles_per_cell;
    spec.boxes = boxes;
    spec.soils = {{"block", materials::LinearElastic{{density, young, 0.0}}}};
    const double half = 0.5 * side;
    spec.regions = {{0, {{-half, -half}, {half, -half}, {half, half}, {-half, half}}}};
    spec.scheme = scheme;
    return spec;
  }

  /// The domain with the velocities (and their gradients) of half a step before the start.
  mpm_domain::Domain& released() {
    const double dt =
        domain_.spec.scheme.fraction * mpm_domain::critical_time_step(domain_, amplitude_ * omega);
    const double rate = amplitude_ * omega * std::cos(0.5 * omega * dt);
    for (mpm_domain::Particles& p : domain_.sets)
      for (std::size_t k = 0; k < p.size(); ++k) {
        const double cos_x = std::cos(wave_number * p.x[k]);
        const double cos_y = std::cos(wave_number * p.y[k]);
        p.vx[k] = rate * std::sin(wave_number * p.x[k]);
        p.vy[k] = -rate * std::sin(wave_number * p.y[k]);
        if (p.traits.affine)
          set_affine_velocity(domain_, p, k,
                              {.xx = rate * wave_number * cos_x, .yy = -rate * wave_number * cos_y});
      }
    return domain_;
  }

  double displacement(double at, double sign) const {
    return sign * amplitude_ * std::sin(wave_number * at) * std::sin(omega * stepper_.time());
  }
  double stretch(double at, double sign) const {
    return 1.0 +
           sign * amplitude_ * wave_number * std::cos(wave_number * at) * std::sin(omega * stepper_.time());
  }
  /// b along the axis of coordinate `along` and sign, where the other coordinate is `across`.
  double body_acceleration(double along, double across, double sign) const {
    const double f = stretch(along, sign);
    const double j = f * stretch(across, -sign);
    return omega * omega * displacement(along, sign) * (j / (f * f) - 1.0);
  }

  double amplitude_;
  mpm_domain::Domain domain_;
  mpm_domain::Stepper stepper_;
};

} // namespace tremolo::test_support
