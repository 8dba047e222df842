#pragma once

#include "mpm_domain/ground.hpp"
#include "mpm_domain/strain/gather_sums.hpp"

namespace tremolo::mpm_domain {

/// The quantities of the particles that a gather pass updates: velocity, position and strain together,
/// velocity alone, strain alone, or the remapped strain with position or drift.
struct GatherParts {
  bool velocity = false; ///< v_p (and C_p with APIC)
  bool position = false; ///< x_p += dt sum_i S_ip v+_i
  bool drift = false;    ///< x_p += dt v_p: equal to `position` once APIC has gathered v_p
  bool strain = false;   ///< strain increment from the grid velocity, then stress, state and volume
  bool remapped = false; ///< the strain is that of the remapped velocity, not of v+
  bool sharp = false;    ///< of a domain with reduced dispersion: bilinear velocity, strain in wide boxes

  friend constexpr bool operator==(const GatherParts&, const GatherParts&) = default;
};

/// Grid to the particles of a clock over its step dt (s).
///
///   apic:  v_p = sum_i S v+,  C_p = sum_i S v+ (x_i - x_p)^T D_p^-1
///   flip:  v_p += sum_i S (v+ - v-)
///
/// With A = dt sum_i u_i grad S, u being v+ or the remapped velocity, the strain increment de is the
/// symmetric part of A - A^2/2, the rotation its skew part. Volumes grow by det(I + A), to second order in A;
/// boxes that follow the soil by I + A (particle_boxes.hpp).
/// @throws std::logic_error for a combination of parts that no step uses
GatherTotals gather(Ground& ground, double dt, GatherParts parts, int clock);

/// Gathers for the particles of all clocks over the same step dt (s).
GatherTotals gather(Ground& ground, double dt, GatherParts parts);

/// The velocity of the soil at particle k of one set after the last update, m/s, for output: that of the
/// particle, with reduced dispersion without what its mean over nodes has taken (sharp_transfer.hpp).
Vector particle_velocity(const Ground& ground, const Particles& particles, std::size_t k);

/// The grid's acceleration of the last update at particle k of one soil, m/s2, for output.
Vector particle_acceleration(const Ground& ground, const Particles& particles, std::size_t k);

} // namespace tremolo::mpm_domain
