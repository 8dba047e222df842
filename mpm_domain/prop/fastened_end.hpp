#pragma once

// An end of a prop. On a rigid body it is a point X of the body. In an elastic body, or in the ground, it
// holds the particles within about a cell of X, with shares w_p that reproduce linear fields,
//
//     sum w_p = 1,      sum w_p x_p = X,      w_p = m_p/M (1 + (X - x_c)^T J^-1 (x_p - x_c)),
//     J = sum m_p/M (x_p - x_c)(x_p - x_c)^T,
//
// x_c being their centroid (moving least squares). So the end goes on as X of a body that moves and turns as
// a whole, and a force on it has its moment about every point. The force goes to nodes as the particles' own,
//
//     f_i = N sum w_p S_ip,      dX/dt = sum w_p S_ip v_i,
//
// so that its power is that of the nodes. The nodes' masses are at least sum m_p S_ip, so the end moves under
// a force with no less mass than
//
//     1/m = sum w_p^2/m_p.

#include "mpm_domain/contact/contact.hpp"
#include "mpm_domain/kernel/node_share.hpp"
#include "mpm_domain/spec/prop.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace tremolo::mpm_domain {

class FastenedEnd {
public:
  /// Particles that it holds stay whole from then on.
  /// @param ground  at the start; all ranks that have filled it call this
  /// @throws std::invalid_argument for a structure that is not there, or a point without particles
  FastenedEnd(const PropFastening& fastening, Ground& ground, const Contact& contact);

  /// Present position of the end, m.
  Vector position(const Ground& ground, const Contact& contact) const;
  /// Around the particles here that it holds, or around nothing; none: it is on a rigid body.
  std::optional<mesh::Rectangle> bounds(const Ground& ground) const;
  /// Finds the nodes that it pulls at, for the particles' present positions.
  void follow(const Ground& ground);
  /// Its velocity from those of the nodes after the update, or of its body, m/s.
  Vector velocity(const Ground& ground, const Contact& contact) const;
  /// The body that takes its force, none where nodes do: its place in Contact::bodies().
  const std::optional<std::size_t>& body() const { return body_; }
  /// Adds a force (N/m) to those of its nodes.
  void pull_nodes(Ground& ground, const Vector& force) const;
  /// 1/m along the direction in which that is largest, m/kg.
  double mobility() const { return mobility_; }

private:
  /// A particle that it holds.
  struct Held {
    std::size_t set;
    std::uint32_t id;
    double share;   ///< w_p
    double start_x; ///< m
  };

  void hold_particles(const Vector& position, Ground& ground, std::size_t first_set, std::size_t end_set);
  Vector arm(const RigidBody& body) const;

  std::optional<std::size_t> body_; ///< rigid
  Vector arm_;                      ///< X - X_c of the body at the start, m
  std::vector<Held> held_;
  std::vector<NodeShare> nodes_; ///< sum w_p S_ip; a node may stand several times
  double mobility_ = 0.0;
};

} // namespace tremolo::mpm_domain
