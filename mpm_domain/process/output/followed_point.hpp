#pragma once

#include "mpm_domain/domain.hpp"
#include "mpm_domain/spec/output_columns.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/transfer/snapshot.hpp"
#include "scene/case.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// State of the pore water at a particle; zero where there is none.
struct WaterState {
  double pressure = 0.0; ///< Pa
  double excess = 0.0;   ///< over the hydrostatic one of the present position, Pa
  double ratio = 0.0;    ///< excess over the vertical effective stress before the shaking
  Vector flux;           ///< Darcy velocity, m/s
};
WaterState water_state(const Particles& set, std::size_t k);

/// The largest magnitude of an excess pore pressure ratio, over the particles of all ranks, 1. It is taken
/// over the weight of a cell of water where less than that rests on a particle.
double largest_pressure_ratio(const Ground& ground);

/// Position of a particle at the time of its velocity, half a step before the present, m.
Vector position_of(const Particles& set, std::size_t k, double dt);

/// Displacement since the start at the time of the velocity, m.
Vector displacement(const Particles& set, std::size_t k, double dt);

/// A particle's motion in time of the soil, half a step before the present.
struct ParticleMotion {
  Vector position;     ///< on a rigid base, where there is one, m
  Vector displacement; ///< in space, as the others, m
  Vector velocity;     ///< m/s
  Vector acceleration; ///< m/s2
};
ParticleMotion motion_in_space(const Snapshot& snapshot, ParticleName particle, const Stepper& stepper);

/// A particle of soil, or of an elastic structure, whose motion, stress and strain are written as histories.
///
/// The strain is that of the displacements u since the start over the positions X at the start,
///
///     G = sum (u_n - u) (X_n - X)^T [sum (X_n - X) (X_n - X)^T]^-1,    eps = (G + G^T) / 2,
///
/// the fit of least squares over the particles n around it in its own soil. It is exact for displacements
/// that are linear in X, at an interface as well; where particles surround it evenly, to second order of
/// their distance. Large rotations count as strain.
class FollowedPoint {
public:
  /// Distance from which particles no longer count as neighbours, over their own size.
  static constexpr double reach_of_neighbours = 1.6;

  /// The particle nearest to a point at the start, of soil or of a structure; it stays whole. Those around it
  /// may be cut, and no longer count then: to look at soil must not change how it moves.
  /// @param sets  the particles of the domain, or as many of them as hold the nearest and its neighbours
  FollowedPoint(Domain& domain, std::span<const Particles> sets, scene::Point point,
                std::optional<std::size_t> structure = std::nullopt);

  /// Names and units of what values() gives.
  static std::vector<OutputColumn> columns(const scene::Case& scene);

  /// Appends position, displacement, velocity, acceleration, effective stress, strain and, in a case with
  /// water, pore pressure and its ratio, as columns() names them. Strain is NaN where the soil has too few
  /// particles around the point.
  void append_values(const Snapshot& snapshot, const Stepper& stepper, bool water,
                     std::vector<double>& row) const;

  /// Adds the particles that the values depend on.
  void add_followed(std::vector<ParticleName>& to) const;

  friend bool operator==(const FollowedPoint& a, const FollowedPoint& b) {
    return a.set_ == b.set_ && a.id_ == b.id_;
  }

private:
  struct Neighbour {
    std::uint32_t id = 0;
    Vector offset; ///< X_n - X, m
  };
  /// xx, yy and the engineering shear strain xy.
  struct Strain {
    double xx = 0.0, yy = 0.0, xy = 0.0;
  };

  void find_neighbours(const Particles& set);
  Strain strain(const Particles& set, double dt) const;

  std::size_t set_ = 0;
  std::uint32_t id_ = 0;
  std::vector<Neighbour> neighbours_;
};

} // namespace tremolo::mpm_domain
