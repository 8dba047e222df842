#pragma once

// The nodes at which soil and a body meet: those that soil has given mass and that the body's surface
// touches, and those with soil inside the body. An elastic body has mass of its own there. Where soil faces
// an edge of it, they meet also at faint nodes, to which its surface reaches a little: what these pass on is
// as little, but left alone they would part from the body. Its strain there is its own, though.
//
// What stands for soil here may be another elastic body, with its particles and its lattice: so bodies meet
// each other. Its particles reach no farther than its surface, which cuts their squares.
//
// What contact asks of the soil is summed over the particles near the body,
//
//     g = sum V grad S,      volume = sum V S,      friction = sum V S mu / volume.
//
// The gap of a particle is the distance of its place from the surface of the body, less what its box reaches
// along the normal, l (|n_x| + |n_y|), or, at a corner, l. That of a node is the mean, weighted by V S, over
// the particles of the soil's surface that reach it and face an edge of the body; for a plane surface this is
// the gap at the node. Where corners alone face the soil it is the least. A node that is not tied closes when
// its gap does, and so does not meet a body early that comes back; a tied one is released by its impulse, and
// by a gap where that shows beyond doubt. Dry soil that shakes needs less gap for that than bonds and wet
// soil, whose pressure is missed where a node opens: a round body would be lifted by the nodes ahead of it.
//
// The normal n from soil to body may come from either side. That of the body is the mean of the normals of
// its edges next to these particles; corners have none. That of the soil, n = g/|g|, leaves the pressure of
// pore water without a tangential rest at any node, since its force there is p g. So it is taken where soil
// has a pore pressure, and where corners alone touch. Soil ends at a node for other reasons than the body,
// too, at the ground surface beside a wall, say: where both normals are far apart, the body's holds. Dry soil
// takes the body's at every edge: its surface is smooth where that of soil made of squares is not.

#include "mpm_domain/contact/impulses/rigid_contact.hpp"
#include "mpm_domain/contact/wall_nodes.hpp"

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

struct BodyLattice;
struct Ground;
struct Particles;

/// Identity of a contact node, which stays the same from step to step while lattices move.
struct NodeKey {
  std::optional<std::size_t> against; ///< the elastic structure in the place of the soil; none: soil
  int row = 0;                        ///< among the nodes of the soil's finest lattice
  int column = 0;

  auto operator<=>(const NodeKey&) const = default;
};

/// A change of velocities at a node by the other contacts that act there, m/s.
struct ChangeByOthers {
  Vector solid, water, body;
};

struct ContactNode : ContactPoint {
  NodeKey key;
  std::size_t node = 0; ///< of the soil, or of the elastic structure in its place
  Vector position;
  double area = 0.0;                ///< A, of the interface per metre out of plane, m
  double gap = 0.0;                 ///< m; negative: they overlap
  double solid_mass = 0.0;          ///< m_s, kg/m
  double water_mass = 0.0;          ///< m_f, of water that moves by itself, kg/m
  double drag = 1.0;                ///< 1 + lambda dt
  double free_impulse = 0.0;        ///< m~_f v_f*.n without bodies, kg/s
  Vector solid_before, solid_trial; ///< v_s before the update and after it, m/s
  Vector water_before, water_trial; ///< v_f
  double solid_normal = 0.0;        ///< v_s.n and v_f.n that the impulses start from, m/s
  double water_normal = 0.0;
  Vector solid_change, water_change; ///< of both by the impulses found
  std::size_t body_node = 0;         ///< that of an elastic body
  bool faint = false;                ///< the surface of an elastic body reaches it a little
  double body_mass = 0.0;            ///< m_b there, kg/m; 0: the body is rigid
  Vector body_before, body_trial;    ///< its velocity before the update and after it, m/s
  Vector body_velocity;              ///< that the impulses start from, m/s
  Vector body_change;                ///< by the impulses found

  /// Takes trial velocities that differ from those of the update by what other contacts have changed.
  void set_trial(const ChangeByOthers& others);
  /// Whether what its tangential impulse does is sliding. A node of an elastic body that sticks may begin its
  /// step with a velocity other than the soil's, by the transfer from particles; to end that is impact.
  bool rubs() const { return body_mass == 0.0 || slip != 0; }
  /// Finds the impulses between soil and the body's node, where the body is elastic: with the mass M of that
  /// node, N = m M/(m + M) (v_n - V_n), and T likewise where it sticks. In this form a node that is all but
  /// empty, whose trial velocity means nothing, does not push the other by the rounding of that velocity.
  /// @param bonded  the node sticks if it is closed, whatever it would bear
  void solve_alone(bool bonded);
  /// Finds the changes of all velocities by the present impulses.
  void find_changes();
};

/// A particle near a body.
struct NearParticle {
  std::uint32_t set;
  std::uint32_t index;
};

/// The particles of the soil in a box with a margin (m) around it.
std::vector<NearParticle> particles_near(const Ground& ground, mesh::Rectangle box, double margin);

/// An elastic structure that meets a body as the soil does.
struct OtherStructure {
  std::size_t structure = 0;
  std::size_t number = 0;           ///< among the elastic ones
  double friction = 0.0;            ///< between both
  std::vector<NearParticle> near{}; ///< its particles near the body, until the next sort
};

/// Particles that were brought back out of a body.
struct PushedOut {
  double farthest = 0.0; ///< the longest way back of one of them, m
  long count = 0;
};

/// Brings particles that lie in a body by more than half of their half side back to its surface.
PushedOut push_out(Ground& ground, const BodySurface& surface, std::span<const NearParticle> near);

/// The particles that may come to touch a body, and what of it is found anew in every step.
class ContactNodes {
public:
  /// Lets the body meet elastic structures besides the soil, in the order of their numbers.
  void meet_others(std::vector<OtherStructure> others) { others_ = std::move(others); }

  /// Takes the particles near the body until the next sort.
  void follow_sort(const Ground& ground, const BodySurface& surface, double margin);

  /// Finds the nodes and what does not depend on their motion.
  /// @param centre  of mass of the body, m
  /// @param own     lattice of the body; null: it is rigid
  /// @param bonded  soil and body are to stick together, as wished in place
  /// @param surfaces  of all structures, in their order
  void find(Ground& ground, const BodySurface& surface, const Vector& centre, const Structure& structure,
            const BodyLattice* own, bool bonded = false, std::span<const BodySurface* const> surfaces = {});
  /// Opens nodes of dry soil whose gap only bonds may have.
  /// @param h  cell size, m
  void end_bonds(const ContactGaps& gaps, double h);

  /// Takes the motion of the soil after an update over dt (s), before contact.
  void take_trial(const Ground& ground, double dt);
  /// Takes the motion of the soil during the gravity stage, when water is at rest.
  void take_relaxing(const Ground& ground, double dt);

  std::vector<ContactNode>& nodes() { return nodes_; }
  /// Whether nodes have been found before; until then a body stays where it was specified, tied to the soil.
  bool placed() const { return placed_; }
  /// Goes on from nodes of which number and sets are known.
  void go_on_from(std::vector<ContactNode> nodes, bool placed) {
    nodes_ = std::move(nodes);
    placed_ = placed;
  }
  const std::vector<ContactNode>& nodes() const { return nodes_; }
  /// Particles of the soil near the body.
  const std::vector<NearParticle>& near() const { return near_; }
  /// The near particles that may come to lie in the body until the next sort.
  const std::vector<NearParticle>& may_enter() const { return may_enter_; }

private:
  /// Sums at a node of the window.
  struct Sums {
    Vector gradient;
    double volume = 0.0;
    double friction = 0.0; ///< sum V S mu
    double adhesion = 0.0; ///< sum V S c
    double sealed = 0.0;   ///< sum V S of soil whose water moves with its grains
    Vector sealed_force;   ///< sum V p_e grad S of it
    double wet = 0.0;      ///< sum V S of soil with a pore pressure
    double suction = 0.0;  ///< sum V S (p_cav - hydrostatic) of it
    Vector facing;         ///< sum V S n of them
    double least_gap = std::numeric_limits<double>::infinity(); ///< of its particles, m
    double surface = 0.0; ///< sum V S of surface particles that face an edge
    double gap = 0.0;     ///< sum V S gap of them
  };

  /// Contact of a near particle with the body: the surface normal, from soil to body.
  struct Touch {
    double gap = std::numeric_limits<double>::infinity(); ///< m
    bool corner = false;
    Vector normal;
  };

  /// Contribution of a near particle to a node of the window within its reach.
  struct Entry {
    std::size_t near;
    std::size_t position;
    double volume;   ///< V S, m2
    Vector gradient; ///< V grad S, m
  };

  /// Whether the body's surface reaches a window node that carries soil.
  enum class Reach : std::uint8_t { none, faint, whole };

  /// Finds the nodes at which the body meets what lies on a lattice: the soil, or another structure.
  struct Meeting;
  void find_nodes(Ground& ground, const Meeting& meeting, std::span<const ContactNode> before);
  /// Finds which nodes of the window the surface reaches.
  void find_reach(const Ground& ground, const Meeting& meeting);
  /// Finds what near particles give to these nodes, and how those that give anything touch the body.
  void weigh_particles(Ground& ground, const Meeting& meeting);
  static Touch touch(const Meeting& meeting, const Particles& p, std::size_t k);
  void sum_particles(const Ground& ground, const Meeting& meeting);
  /// Finds the arms of the nodes of a rigid body (bearing.cpp).
  void bear_on(const BodySurface& surface, const Vector& centre, double h);

  std::vector<NearParticle> near_, may_enter_;
  std::vector<OtherStructure> others_;
  std::vector<Touch> touches_;              ///< by near particle of one meeting
  std::vector<std::vector<Entry>> entries_; ///< by near particle, in parts
  NodeWindow window_;
  std::vector<double> wall_;  ///< L_I
  std::vector<Reach> reach_;  ///< of nodes of the window
  NodeWindow firsts_;         ///< first nodes of particles that may reach the window
  std::vector<char> reaches_; ///< by these: whether the particle reaches a node that the surface reaches
  std::vector<Sums> sums_;
  std::vector<Sums> of_nodes_; ///< of nodes_, in their order
  std::vector<ContactNode> nodes_;
  bool placed_ = false;
};

} // namespace tremolo::mpm_domain
