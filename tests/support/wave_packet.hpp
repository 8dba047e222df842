#pragma once

// What a boundary reflects of a plane wave at one angle. In a periodic domain of width L only horizontal wave
// numbers 2 pi/L fit, so a packet that is narrow in the vertical wave number k_y around k_x/tan(angle) is a
// plane wave of nearly one angle. It is a sum of exact plane waves, all of them going down:
//
//     v = Re sum_k a_k d_k exp(i (k_x x - k_y (y - y_c))),      |a_k| Gaussian in k_y.
//
// When the packet has met the base, the energy left in the domain over the one at the start is what came
// back, P and SV together, averaged over the packet's angles.

#include "tests/support/quiet_ground.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

namespace tremolo::test_support {

struct WavePacket {
  bool sv = true;
  double angle_deg = 0.0;      ///< from the base's normal
  double wavelength = 0.0;     ///< m, at the centre of the packet
  double relative_width = 0.1; ///< standard deviation of k_y over its mean
  double height = 0.0;         ///< of the centre above the base, m
  materials::Elasticity ground{1700.0, 40e6, 0.28};

  double speed() const { return sv ? ground.s_wave_speed() : ground.p_wave_speed(); }
  double angle() const { return angle_deg * std::numbers::pi / 180.0; }
  double k_x() const { return 2.0 * std::numbers::pi / wavelength * std::sin(angle()); }
  double k_y() const { return 2.0 * std::numbers::pi / wavelength * std::cos(angle()); }

  /// A plane wave of the packet: amplitude, vertical wave number, angle.
  struct Ray {
    double amplitude, k_y;
  };
  std::vector<Ray> rays() const {
    std::vector<Ray> all;
    for (int i = -24; i <= 24; ++i) {
      const double s = i / 8.0; // standard deviations
      all.push_back({std::exp(-0.5 * s * s), k_y() * (1.0 + s * relative_width)});
    }
    return all;
  }
};

/// Kinetic energy of the grid after the last step, J/m: half the energy of waves that travel freely. (The
/// other half holds in MPM also stresses that differ between the particles of a cell, which no grid velocity
/// changes.)
inline double wave_energy(const mpm_domain::Domain& domain) {
  return 2.0 * domain.energy.kinetic;
}

/// Gives the particles the packet's velocity and stress.
inline void lay(const WavePacket& packet, mpm_domain::Domain& domain, double peak) {
  const double base = domain.spec.box.y_min;
  const double mu = packet.ground.density * std::pow(packet.ground.s_wave_speed(), 2);
  const double lame = packet.ground.density * std::pow(packet.ground.p_wave_speed(), 2) - 2.0 * mu;
  const double k_x = packet.k_x();
  double sum = 0.0;
  for (const auto& ray : packet.rays())
    sum += ray.amplitude;
  for (mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      const double x = set.x[k], y = set.y[k] - base - packet.height;
      for (const auto& [amplitude, k_y] : packet.rays()) {
        const double wave_number = std::hypot(k_x, k_y);
        const double sine = k_x / wave_number, cosine = k_y / wave_number;
        // Polarisations of a wave along (sine, -cosine).
        const double dx = packet.sv ? cosine : sine, dy = packet.sv ? sine : -cosine;
        const double a = peak * amplitude / sum;
        const double v = a * std::cos(k_x * x - k_y * y);
        // Displacement rate i omega u = v: strain = -(direction) v/c.
        const double e = -v / packet.speed();
        const double exx = e * sine * dx, eyy = -e * cosine * dy, gxy = e * (sine * dy - cosine * dx);
        set.vx[k] += v * dx;
        set.vy[k] += v * dy;
        set.sxx[k] += lame * (exx + eyy) + 2.0 * mu * exx;
        set.syy[k] += lame * (exx + eyy) + 2.0 * mu * eyy;
        set.szz[k] += lame * (exx + eyy);
        set.sxy[k] += mu * gxy;
      }
    }
}

/// Periodic elastic ground, one horizontal wavelength of the packet wide.
inline mpm_domain::Spec packet_ground(const WavePacket& packet, double h, double height) {
  const double width =
      packet.angle_deg == 0.0 ? h : packet.wavelength / std::sin(packet.angle()); // a multiple of h
  mpm_domain::Spec spec;
  spec.box = {0.0, 0.0, std::round(width / h) * h, height};
  spec.cell_size = h;
  spec.soils = {{"ground", materials::LinearElastic{packet.ground}}};
  spec.regions = {{0, {{0.0, 0.0}, {spec.box.x_max, 0.0}, {spec.box.x_max, height}, {0.0, height}}}};
  spec.sides = mpm_domain::Sides::periodic;
  spec.scheme.transfer = mpm_domain::Transfer::flip; // with musl it keeps the energy of waves
  spec.scheme.order = mpm_domain::StepOrder::musl;
  return spec;
}

/// Share of the packet's energy that comes back from the base, by dashpots or (cells > 0) by a matched layer.
inline double reflected_energy(const WavePacket& packet, double h, double height, int layer_cells) {
  mpm_domain::Spec spec = packet_ground(packet, h, height);
  if (layer_cells > 0) {
    spec.matched_sides = {mpm_domain::Side::base};
    spec.layer_cells = layer_cells;
  }
  mpm_domain::Domain domain(spec);
  lay(packet, domain, 1e-3);
  mpm_domain::Stepper stepper(domain, 0.0, quiet_ground());
  stepper.step();
  const double before = wave_energy(domain);
  // Until the packet's centre would be as far below the base as it was above it.
  const double arrival = packet.height / (packet.speed() * std::cos(packet.angle()));
  while (stepper.time() < 2.0 * arrival)
    stepper.step();
  return wave_energy(domain) / before;
}

} // namespace tremolo::test_support
