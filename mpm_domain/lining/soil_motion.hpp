#pragma once

// Motion of the soil's nodes before contact, and their response to an impulse j. Where nothing but the grains
// moves, or water along with them, a node's velocity changes by j/m. Where water flows, a lining lets none
// pass: along the normal n of its surface at the node, grains and water move as one, and only the grains take
// what acts along it, to which drag ties the water,
//
//     dv_s = n j_n/(m_s + m_f) + t j_t/m*,      dv_f = dv_s - t j_t/(m_s (1 + lambda dt)),
//     m* = (m_s + m_f)/(1 + (m_f/m_s)/(1 + lambda dt)),
//
// as at rigid bodies (contact/impulses/rigid_contact.hpp). Both changes together have the momentum j.

#include "base/vector.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace tremolo::mpm_domain {

/// A node at a lining with water that flows.
struct NodeFlow {
  std::size_t node;
  Vector normal;
  double solid_mass; ///< m_s, kg/m
  double water_mass; ///< m_f, kg/m
  double drag;       ///< 1 + lambda dt

  double mass() const { return solid_mass + water_mass; }
  Vector tangent() const { return {-normal.y, normal.x}; }
  /// dv_s for an impulse on the node, m/s.
  Vector of_grains(const Vector& impulse) const {
    const Vector t = tangent();
    const double across = dot(normal, impulse) / mass();
    const double along = dot(t, impulse) / mass() * (1.0 + water_mass / solid_mass / drag);
    return {across * normal.x + along * t.x, across * normal.y + along * t.y};
  }
  /// dv_f, m/s.
  Vector of_water(const Vector& impulse) const {
    const Vector t = tangent();
    return of_grains(impulse) - dot(t, impulse) / (solid_mass * drag) * t;
  }
};

/// Masses (kg/m) and velocities of the nodes.
struct SoilMotion {
  std::span<const double> mass, vx, vy;
  std::span<const NodeFlow> flows = {}; ///< nodes with water that flows, in their order

  const NodeFlow* flow(std::size_t node) const {
    const auto found = std::ranges::lower_bound(flows, node, {}, &NodeFlow::node);
    return found != flows.end() && found->node == node ? &*found : nullptr;
  }
  /// Velocity change of a node's grains due to an impulse, m/s.
  Vector of_grains(std::size_t node, const Vector& impulse) const {
    if (const NodeFlow* at = flow(node))
      return at->of_grains(impulse);
    return impulse / mass[node];
  }
};

} // namespace tremolo::mpm_domain
