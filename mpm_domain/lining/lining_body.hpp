#pragma once

// A lining in the domain: its beam (beam/beam.hpp), its surface as the beam carries it (surface.hpp), and
// contact with the soil (lining_contact.hpp). In a step the beam makes its implicit step without contact, the
// grid its update, and the impulses of contact change both.
//
// Where the velocities that strain the soil are remapped (musl), segments that are tied take from them what
// would drive soil into the lining, which moves no particle and no beam.
//
// In wet soil, hydrostatic pressure acts on the beam (water_load.hpp), and what water and grains bear beyond
// it comes through contact (water_before.hpp). A lining is impervious: at the nodes of its segments no water
// flows along the normal.
//
// Energy. The beam's kinetic energy changes by the powers of impulses, weight and elements on (v- + v+)/2.
// What the elements take is booked as elastic work as far as their strain energy grows, and the rest, what
// backward Euler damps, as viscous.

#include "mpm_domain/contact/body_surface.hpp"
#include "mpm_domain/contact/contact_nodes.hpp"
#include "mpm_domain/lining/lining_contact.hpp"
#include "mpm_domain/lining/soil_motion.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

struct Grid;
struct Ground;

/// Changes of energy by a lining in a step, J/m.
struct LiningWork {
  double kinetic = 0.0;  ///< of the soil's nodes, grains and water
  double gravity = 0.0;  ///< work of weight and water at rest on the beam, and on what contact changes
  double drag = 0.0;     ///< as in MixtureUpdate
  double elements = 0.0; ///< what the elements have taken from the motion of the beam
  double friction = 0.0; ///< dissipated by sliding, >= 0
  double impact = 0.0;   ///< dissipated where lining and soil meet, or part
};

class LiningBody {
public:
  /// Creates the lining in place, free of stress and at rest.
  /// @throws std::invalid_argument for a lining that cannot be built
  LiningBody(const Lining& lining, const Ground& ground);

  const std::string& name() const { return lining_.name; }
  const Beam& beam() const { return beam_; }
  const LiningContact& contact() const { return contact_; }
  const std::vector<SegmentRows>& rows() const { return rows_; }
  const std::vector<SurfaceSegment>& segments() const { return carried_.segments(); }
  const std::vector<std::size_t>& hinges() const { return lining_.hinges; }
  double thickness() const { return lining_.thickness; } ///< m
  /// Corners of the surface now, counter-clockwise, m.
  const std::vector<Vector>& outline() const { return surface_.points(); }
  mesh::Rectangle bounds() const { return surface_.bounds(); } ///< of its outline
  double fastest_point() const;                                ///< m/s
  /// Particles that had to be brought back out of the lining, over all steps.
  long pushed_out() const { return pushed_out_; }

  /// Takes the particles near the lining until the next sort.
  /// @throws OutOfReach if the lining has left the grid
  void follow_sort(const Ground& ground);

  /// Contact of the grid's motion after the grid update, and the beam's step.
  /// @param kick  time that forces act for, s
  /// @param dt    time that places move for, s
  LiningWork meet(Ground& ground, double kick, double dt);

  /// Contact of the remapped velocities.
  /// @returns power of nodal forces on what it has taken off these velocities, W/m
  double meet_remapped(Ground& ground) const;

  /// Moves the beam, and brings back to its surface particles that lie in it by more than half of their half
  /// side.
  /// @returns the longest way back of a particle, m
  double move(Ground& ground, double dt);

  /// Finds the segments of the gravity stage, in which nothing moves.
  void begin_rest(const Ground& ground) { find_segments(ground); }
  /// A step of relaxation, after that of the grid: v+ = keep v + gain f/m. The beam is strained in place.
  /// @param bonded    soil and lining stick together, whatever that takes
  /// @param left_out  nodes that do not count, one entry a node
  /// @returns sum of squares of the unbalanced forces of the nodes that it touches and of its own, (N/m)^2
  double relax(Ground& ground, double keep, double gain, double dt, bool bonded,
               std::span<const unsigned char> left_out);
  void end_rest();

  /// Beam and contact of the lining as the model before has left it. Water at rest goes on to press as it did
  /// there until the pressure grows.
  void carry_over(const LiningBody& before, const Ground& model_before);
  /// Lets water at rest press with what lies at a share (1) of the way from there to what it is here.
  void grow_water(double share) { water_share_ = share; }

  /// State for a checkpoint, and its restoration.
  std::vector<double> state() const;
  /// @throws std::runtime_error for the state of another lining
  void set_state(std::span<const double> state);

private:
  void find_segments(const Ground& ground);
  void take_soils(const Ground& ground);
  /// The particles that may lie in the lining.
  const std::vector<NearParticle>& near_surface(const Ground& ground);
  /// Hydrostatic pressure on the beam, N/m and N.
  std::vector<double> water_loads(const Ground& ground) const;
  /// Weight and hydrostatic pressure, likewise.
  std::vector<double> loads(const Ground& ground) const;
  /// Books the work of the impulses on the beam, whose velocity becomes v, and on the nodes.
  /// @param weight  loads(), N/m and N
  void book_beam(const Grid& grid, std::span<const double> weight, std::span<const double> v, double kick,
                 LiningWork& work) const;

  Lining lining_;
  Beam beam_;
  LiningSurface carried_;
  BodySurface surface_;
  std::vector<NearParticle> near_;
  std::vector<NearParticle> inside_box_; ///< those of them that may lie in the lining until the next sort
  std::vector<NearParticle> suspects_;   ///< those that may lie in it now
  LiningContact contact_;
  std::vector<SegmentRows> rows_;    ///< of the last step
  std::vector<NodeFlow> flows_;      ///< likewise
  std::vector<double> water_before_; ///< forces of water at rest in the model before; none: there is no such
  double water_share_ = 1.0;
  long pushed_out_ = 0;
};

} // namespace tremolo::mpm_domain
