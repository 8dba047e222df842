#pragma once

// A train of plane pulses in elastic ground that is periodic along x, and what is left of it after a way. The
// ground is so tall that nothing from its ends comes near the middle, where the velocity is compared:
//
//     v = d f(n . (x, y) - c t),    f(s) = V sum_j r(s - j P),    P = spacing of the pulses,
//
// n = (sin, cos) of the angle, d the polarisation, r a Ricker pulse or a cosine.

#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/transfer/gather.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace tremolo::test_support {

struct PlanePulse {
  bool sv = true;
  bool harmonic = false;   ///< a cosine of `wavelength` instead of Ricker pulses
  double angle_deg = 0.0;  ///< from the vertical, upwards
  double wavelength = 0.0; ///< at the peak of the spectrum, m
  double spacing = 0.0;    ///< P, m
  double velocity = 1e-4;  ///< V, m/s
  materials::Elasticity ground{1700.0, 40e6, 0.28};

  double speed() const { return sv ? ground.s_wave_speed() : ground.p_wave_speed(); }
  Vector direction() const {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    return {std::sin(angle), std::cos(angle)};
  }
  Vector polarisation() const {
    const Vector n = direction();
    return sv ? Vector{n.y, -n.x} : n;
  }
  double along(double x, double y, double t) const {
    const Vector n = direction();
    const double s = n.x * x + n.y * y - speed() * t;
    if (harmonic)
      return velocity * std::cos(2.0 * std::numbers::pi * s / wavelength);
    const double a = std::pow(std::numbers::pi * std::remainder(s, spacing) / wavelength, 2);
    return velocity * (1.0 - 2.0 * a) * std::exp(-a);
  }
  Vector at(double x, double y, double t) const {
    const Vector d = polarisation();
    const double v = along(x, y, t);
    return {v * d.x, v * d.y};
  }
};

/// Ground for a pulse and where it is compared.
struct PulseGround {
  double h = 0.0;             ///< m
  double width = 0.0;         ///< of the period, m
  double travelled = 0.0;     ///< way of the pulse, m
  double strip = 0.0;         ///< height of the middle that is compared, m
  Vector drift = {};          ///< of all, m/s
  double jitter = 0.0;        ///< of the particles' places, at random, m
  int particles_per_cell = 2; ///< in each direction

  double height(const PlanePulse& pulse) const {
    const double reached = travelled / pulse.speed() * pulse.ground.p_wave_speed();
    return std::ceil((2.0 * reached + strip + 4.0 * pulse.wavelength) / h) * h;
  }
};

inline mpm_domain::Spec ground_of(const PlanePulse& pulse, const PulseGround& ground,
                                  mpm_domain::Dispersion dispersion) {
  const double height = ground.height(pulse);
  mpm_domain::Spec spec;
  spec.box = {0.0, 0.0, ground.width, height};
  spec.cell_size = ground.h;
  spec.particles_per_cell = ground.particles_per_cell;
  spec.soils = {{"ground", materials::LinearElastic{pulse.ground}}};
  spec.regions = {{0, {{0.0, 0.0}, {ground.width, 0.0}, {ground.width, height}, {0.0, height}}}};
  spec.sides = mpm_domain::Sides::periodic;
  spec.scheme.fraction = 0.6 / 0.65; // dt = 0.6 h/c_p
  spec.scheme.dispersion = dispersion;
  return spec;
}

/// Gives particles the velocity that they would have gathered from the exact one of the nodes at one time,
/// and the exact stress of another.
inline void lay(const PlanePulse& pulse, mpm_domain::Domain& domain, double velocity_time, double time) {
  mpm_domain::Grid& grid = domain.grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vector v = pulse.at(grid.x0 + i * grid.h, grid.y0 + j * grid.h, velocity_time);
      grid.vx_after[grid.index(i, j)] = v.x;
      grid.vy_after[grid.index(i, j)] = v.y;
    }
  mpm_domain::gather(domain, 1.0, {.velocity = true, .sharp = domain.is_sharp()});
  const Vector n = pulse.direction();
  const Vector d = pulse.polarisation();
  const double mu = pulse.ground.shear_modulus();
  const double lame = pulse.ground.lame();
  for (mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      const double e = -pulse.along(set.x[k], set.y[k], time) / pulse.speed(); // strain = sym(n d) e
      const double exx = e * n.x * d.x, eyy = e * n.y * d.y;
      set.sxx[k] = lame * (exx + eyy) + 2.0 * mu * exx;
      set.syy[k] = lame * (exx + eyy) + 2.0 * mu * eyy;
      set.szz[k] = lame * (exx + eyy);
      set.sxy[k] = mu * e * (n.x * d.y + n.y * d.x);
    }
}

/// What a pulse has become in the middle of its ground.
struct PulseResult {
  double error = 0.0;  ///< relative L2 of velocity
  double phase = 0.0;  ///< of a harmonic: speed over the exact one, less 1
  double energy = 0.0; ///< kinetic energy over the exact one, less 1
};

/// A free field without waves that moves with the ground.
inline mpm_domain::FreeFieldSource moving_ground(Vector drift) {
  return [drift](long, double, std::span<const Vector>, std::span<eq6::FreeField> field) {
    std::ranges::fill(field, eq6::FreeField{drift, {}});
  };
}

/// Moves particles from their lattice at random.
inline void unsettle(mpm_domain::Domain& domain, double jitter) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> way(-jitter, jitter);
  for (mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      set.x[k] = set.x_initial[k] += way(random);
      set.y[k] = set.y_initial[k] += way(random);
    }
  mpm_domain::sort_particles(domain);
}

inline PulseResult travel(const PlanePulse& pulse, const PulseGround& ground,
                          mpm_domain::Dispersion dispersion) {
  mpm_domain::Domain domain(ground_of(pulse, ground, dispersion));
  if (ground.jitter > 0.0)
    unsettle(domain, ground.jitter);
  mpm_domain::Stepper stepper(domain, 0.0, moving_ground(ground.drift));
  lay(pulse, domain, stepper.velocity_time(), 0.0);
  for (mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      set.vx[k] += ground.drift.x;
      set.vy[k] += ground.drift.y;
    }
  while (stepper.time() < ground.travelled / pulse.speed())
    stepper.step();
  const double middle = 0.5 * domain.spec.box.y_max;
  const double t = stepper.velocity_time();
  const Vector n = pulse.direction();
  const Vector d = pulse.polarisation();
  double error = 0.0, exact2 = 0.0, found2 = 0.0, in_phase = 0.0, in_quadrature = 0.0;
  for (const mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      if (std::abs(set.y_initial[k] - middle) > 0.5 * ground.strip)
        continue;
      const double x = set.x_initial[k];
      const double y = set.y_initial[k];
      const Vector exact = pulse.at(x, y, t);
      const Vector with_drift = mpm_domain::particle_velocity(domain, set, k);
      const Vector v{with_drift.x - ground.drift.x, with_drift.y - ground.drift.y};
      error += std::pow(v.x - exact.x, 2) + std::pow(v.y - exact.y, 2);
      exact2 += exact.x * exact.x + exact.y * exact.y;
      found2 += v.x * v.x + v.y * v.y;
      const double angle =
          2.0 * std::numbers::pi / pulse.wavelength * (n.x * x + n.y * y - pulse.speed() * t);
      const double found = v.x * d.x + v.y * d.y;
      in_phase += found * std::cos(angle);
      in_quadrature += found * std::sin(angle);
    }
  // cos(s - c' t) with c' = (1 + phase) c lags by k (c - c') t against cos(s - c t).
  const double lead = std::atan2(in_quadrature, in_phase);
  return {.error = std::sqrt(error / exact2),
          .phase = lead / (2.0 * std::numbers::pi * pulse.speed() * t / pulse.wavelength),
          .energy = found2 / exact2 - 1.0};
}

} // namespace tremolo::test_support
