#pragma once

// The structures of a domain and their interaction with the soil in a step: contact_nodes.hpp finds the
// nodes, impulses/rigid_contact.hpp the impulses at all nodes of a rigid body, impulses/collisions.hpp those
// between rigid bodies. Every node of an elastic body (elastic_body.hpp) is solved by itself, as a rigid body
// of one node that cannot turn: with m_b the mass of the body's node, W = m_b and x = 0 there.
//
// An elastic body meets other structures as soil does: its nodes and particles replace the soil's, and the
// other structure gives the surface. If both are elastic, the larger one gives it, since the smaller lies
// against its edges.
//
// Nodes at which several contacts act and bodies that touch each other are solved in turn
// (impulses/solve.cpp), each with the impulses of the others, until nothing changes; every solution conserves
// momentum.
//
// Contact acts after the grid update, and once more on the remapped velocities that strain the soil (musl):
// there it moves no particle and no body.

#include "mpm_domain/contact/contact_nodes.hpp"
#include "mpm_domain/contact/elastic_body.hpp"
#include "mpm_domain/contact/impulses/collisions.hpp"
#include "mpm_domain/contact/structure_loads.hpp"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

struct Ground;
struct Grid;
struct Spec;

/// Changes of energy by contact and the bodies in a step, J/m.
struct ContactWork {
  double kinetic = 0.0;  ///< of the soil's nodes
  double gravity = 0.0;  ///< work of weight and buoyancy on bodies, and on what contact changes of the soil
  double load = 0.0;     ///< work of loads on rigid bodies
  double drag = 0.0;     ///< as in MixtureUpdate
  double friction = 0.0; ///< dissipated by sliding, >= 0
  double impact = 0.0;   ///< dissipated where bodies and soil meet, or part
};

/// Forces on a body at the last step, N/m and N.
struct BodyForces {
  RigidLoad normal; ///< of effective stress
  RigidLoad friction;
  RigidLoad water;  ///< of excess pore pressure
  RigidLoad weight; ///< weight, buoyancy, loads and props
};

class Contact {
public:
  explicit Contact(const Spec& spec);

  bool any() const { return !bodies_.empty(); }
  /// Position and motion by structure; elastic bodies as a whole.
  std::span<const RigidBody> bodies() const { return bodies_; }
  bool is_elastic(std::size_t body) const { return elastic_[body].has_value(); }
  /// An elastic body; null: it is rigid.
  const ElasticBody* elastic(std::size_t body) const { return elastic_[body] ? &*elastic_[body] : nullptr; }
  /// The structure that is the n-th of the elastic ones.
  std::size_t structure_of(std::size_t elastic) const;
  mesh::Rectangle bounds(std::size_t body) const { return surface(body).bounds(); }
  const std::vector<ContactNode>& nodes(std::size_t body) const { return nodes_[body].nodes(); }
  BodyForces forces(std::size_t body) const;
  double kinetic_energy() const; ///< of the rigid bodies, J/m
  /// All loads on a rigid body except contact.
  RigidLoad load(std::size_t body) const;
  /// Speed of the fastest point of all surfaces, those of elastic bodies moving as a whole, m/s.
  double fastest_point() const;
  /// Root of the mean square of a body's speed in the gravity stage, m/s.
  double speed(const Ground& ground, std::size_t body) const;
  /// Particles that had to be brought back out of bodies, over all steps.
  long pushed_out() const { return pushed_out_; }

  /// Takes the particles of elastic bodies, at the start.
  void take_bodies(const Ground& ground);

  /// Takes the particles near bodies until the next sort.
  void follow_sort(const Ground& ground);

  /// Contact of the grid's motion after the grid update.
  /// @param dt time that the forces of the step act for, s
  ContactWork meet(Ground& ground, double dt);

  /// Contact of the remapped velocities, and of the flux of water.
  /// @returns power of nodal forces on what it has taken off these velocities, W/m
  double meet_remapped(Ground& ground);

  /// Moves the rigid bodies for dt (s), lets the elastic ones follow their particles, and brings back
  /// to their surface particles that lie in them by more than half of
  /// their half side.
  /// @returns the longest way back of a particle, m
  double move(Ground& ground, double dt);

  /// Finds the contact nodes of the gravity stage, in which nothing moves, and the corners at which rigid
  /// bodies rest on each other.
  void begin_rest(Ground& ground);
  StructureLoads& structure_loads() { return structure_loads_; }
  const StructureLoads& structure_loads() const { return structure_loads_; }
  /// F/M of the loads on a body, m/s2.
  Vector pull(std::size_t body) const;
  /// Lets weight, buoyancy and loads of a rigid body be what lies at a share (1) of the way from `before` to
  /// what they are, until nodes are found again.
  void weigh(const Ground& ground, std::size_t body, double share, const RigidLoad& before = {});
  /// Weight, buoyancy and loads of a rigid body.
  const RigidLoad& weight(std::size_t body) const { return loads_[body]; }
  /// Takes what props do to rigid bodies in the present step, by body. Their work is booked by the props.
  void take_props(std::vector<RigidLoad> loads) { of_props_ = std::move(loads); }

  /// Adds what a structure does to nodes and, as a load, to rigid bodies, in the last step.
  /// @param dt  time that the impulses of the step act for, s
  void add_forces_of(std::size_t body, double dt, std::span<Vector> nodes, std::span<RigidLoad> bodies) const;

  /// A step of relaxation, after that of the grid: v+ = keep v + gain f/m.
  /// @param bonded  soil and bodies stick together, whatever that takes
  /// @param left_out  nodes that do not count, one entry a node
  /// @returns sum of squares of the unbalanced forces of contact nodes and bodies, (N/m)^2
  double relax(Ground& ground, double keep, double gain, bool bonded,
               std::span<const unsigned char> left_out);
  void end_rest();
  /// Puts a rigid body where static stages have brought it, from where it has been placed.
  /// @param way   of its centre, m
  /// @param turn  counter-clockwise, rad
  void displace(std::size_t body, const Vector& way, double turn);
  /// Lets the elastic bodies follow their particles.
  void follow_particles(const Ground& ground);

  /// State that a checkpoint stores (state.hpp).
  template <class Writer>
  void save(Writer& to) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const std::string name = "body" + std::to_string(b);
      to.write(name, bodies_[b].state());
      to.write(name + ".nodes", node_state(b));
    }
  }
  template <class Reader>
  void restore(const Reader& from) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const std::string name = "body" + std::to_string(b);
      bodies_[b].set_state(from.numbers(name));
      set_node_state(b, from.numbers(name + ".nodes"));
    }
  }

private:
  /// A contact at a node of the grid.
  struct NodeUse {
    std::size_t node;
    std::size_t body;
    std::size_t at; ///< its index among the contact nodes of the body
    bool own;       ///< the node is the elastic body's own, not that of the soil
  };
  /// A contact node of a body whose velocities another contact changes too.
  struct SharedNode {
    std::size_t at;
    bool own;
    NodeUse other;
  };

  /// Finds the contact nodes of all bodies, and their loads.
  void find_nodes(Ground& ground, bool bonded);
  void find_shared();
  const ContactNode& node_of(const NodeUse& use) const { return nodes_[use.body].nodes()[use.at]; }
  /// Calls see(body, node) for contacts in which a structure is the elastic one in the place of the soil.
  template <class See>
  void for_contacts_against(std::size_t structure, const See& see) const;
  const BodySurface& surface(std::size_t body) const {
    return elastic_[body] ? elastic_[body]->surface() : bodies_[body].surface();
  }
  /// Motions of the bodies after dt (s) without contact: v+ = keep v + dt f/m.
  std::vector<RigidMotion> trial_motions(double keep, double dt) const;
  /// Finds impulses and changes of motion at all nodes, and the bodies' motions, from their trial motions.
  void solve(std::span<const RigidMotion> trial, double dt, bool bonded);
  /// Velocity changes due to other contacts at shared nodes, starting at `next`, which advances.
  ChangeByOthers by_others(std::span<const SharedNode>& next) const;
  double solve_rigid(std::size_t body, const RigidMotion& trial, bool bonded);
  double solve_elastic(std::size_t body, bool bonded);
  /// Root of the mean square of the speed of an elastic body's nodes before contact, m/s.
  double node_speed(std::size_t body) const;
  /// @throws OutOfReach if a body has left the grid over a side or the base
  void refuse_beyond_grid(const Ground& ground, std::size_t body) const;
  /// @throws OutOfReach if a body has come to cells on which it does not meet soil
  void refuse_coarse_cells(const Ground& ground, std::size_t body) const;
  ContactWork add_changes(Ground& ground, double dt);
  ContactWork book_body(const Grid& grid, std::size_t body, const RigidMotion& middle, double dt) const;
  /// A body's own part of relax().
  double relax_rigid(std::size_t body, double keep, double gain);
  /// The part of relax() from the nodes at which contacts act.
  double relax_nodes(const Grid& grid, double gain, std::span<const unsigned char> left_out) const;
  std::vector<double> node_state(std::size_t body) const;
  void set_node_state(std::size_t body, const std::vector<double>& state);

  std::vector<Structure> structures_;
  std::vector<RigidBody> bodies_;
  std::vector<std::optional<ElasticBody>> elastic_; ///< by body
  std::vector<ContactNodes> nodes_;
  std::vector<NodeUse> uses_;                   ///< in the order of nodes
  std::vector<std::vector<SharedNode>> shared_; ///< by body, in the order of its nodes
  std::vector<CornerContact> corners_;
  std::vector<RigidMotion> motions_; ///< of bodies, as found by solve()
  std::vector<Response> responses_;
  StructureLoads structure_loads_;
  std::vector<RigidLoad> loads_;    ///< weight, buoyancy and loads in the last step
  std::vector<RigidLoad> of_props_; ///< likewise
  double dt_ = 0.0;                 ///< of the last step, s
  long pushed_out_ = 0;
};

} // namespace tremolo::mpm_domain
