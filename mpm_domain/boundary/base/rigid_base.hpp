#pragma once

// A rigid base that moves as prescribed, whatever the soil above it does: a shaking table. The domain is seen
// from the base, which therefore stands still,
//
//     m dv/dt = f - m dV/dt,      v = 0 at the base,      v_x = 0 at the walls of a container,
//
// v being the velocity relative to the base, and V that of the base. Walls are smooth, and soil does not part
// from them. Base and walls stop the water in the ground too. Water that flows has its own inertia: with m_f
// its mass and M_f that of the water which would fill the soil (water/mixture_kick.hpp),
//
//     F -= (m_s + m_f) dV/dt,      f -= M_f dV/dt.
//
// The base is given V at t_n; nodes of a clock are kicked up to half a step of theirs after a tick. What a
// kick takes off them is the growth since the last one of
//
//     V(t) = V(t_n) + (t - t_n) (V(t_n) - V(t_n-1)) / (t_n - t_n-1),
//
// so that all of it adds up to V, whatever the steps are.
//
// Work is that of the frame: the base itself does none, and inertia does -m dV/dt . v on each phase.

#include "mpm_domain/boundary/support.hpp"
#include "mpm_domain/ranks/exact_sum.hpp"

namespace tremolo::mpm_domain {

/// Motion of the base at one time, in the directions of the axes.
struct BaseMotion {
  Vector displacement; ///< m
  Vector velocity;     ///< m/s
  Vector acceleration; ///< m/s2
};

class RigidBase final : public Support {
public:
  RigidBase(const Ground& ground, std::span<BoundaryFace> faces);

  std::string name() const override { return "rigid base"; }
  /// Finds the nodes that are held, on the present extent of the grid.
  void follow_sort(const Ground& ground) override;
  /// The base has the velocity of the free field at t_n, from which a step begins.
  void exchange(const Exchange& at, std::span<SupportLoad> loads) override;
  /// It takes momentum off the nodes that it holds, and gives inertia, -m dV/dt, to all others in the place
  /// of tractions.
  std::vector<Pass> passes(Ground& ground) override;
  void add_state(SavedNumbers& state) override;

  /// Closes the nodes that are held to water, after the faces have opened all others.
  void close_to_water(NodeFields& nodes) const;

  /// Motion of the base at the time to which output of particles belongs, half a step before
  /// the end of the step just made.
  BaseMotion motion() const;

private:
  /// Takes momentum, and with it velocity, off the nodes that are held.
  void stop(Ground& ground) const;
  /// Adds the inertia of a clock's kick to the forces of its nodes, in these rows, that are free.
  void push(Ground& ground, const Ticks& ticks, int clock, std::span<const NodeRange> rows);
  /// Power (W/m) of that inertia on the mean velocity of an update; the sum of one rank.
  ExactSums<1> power(Ground& ground, int clock, std::span<const NodeRange> rows) const;
  /// Power of that inertia on the difference between v+ and the remapped velocity, W/m.
  ExactSums<1> remap_power(Ground& ground, int clock, std::span<const NodeRange> rows) const;
  /// Takes the inertia of the water off the forces on it again: what is left is that of the pressure alone.
  void release_water(Ground& ground, int clock, std::span<const NodeRange> rows) const;
  /// Base and walls take up the forces on the nodes that they hold.
  void bear(NodeFields& nodes) const;

  /// The base motion as the nodes of one clock have seen it.
  struct Seen {
    Vector velocity;     ///< at the end of the last kick, m/s
    Vector acceleration; ///< in it, m/s2
  };

  std::vector<std::size_t> all_, across_; ///< nodes that are held
  Vector velocity_;                       ///< V(t_n), m/s
  Vector rate_;                           ///< of V from t_n-1 to t_n, m/s2
  std::vector<Seen> seen_;                ///< by clock
  Vector displacement_;                   ///< at t_n, m
  double dt_ = 0.0;                       ///< of the last step, s; none has been made: 0
};

} // namespace tremolo::mpm_domain
