#pragma once

// Loads on structures: a force F (N/m) at the centroid of each, whose direction stays. A rigid body takes it
// beside its weight (contact.hpp). In an elastic one it is spread as its mass is,
//
//     f_i = m_i F/M,
//
// so that its resultant goes through the centroid wherever that has moved. The work of loads is booked as
// that of static tractions.

#include "mpm_domain/passes/pass.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace tremolo::mpm_domain {

class Contact;

class StructureLoads {
public:
  /// Loads that grow while the ground is in motion do not act yet; all others are at their full size.
  /// @throws std::invalid_argument for a load on a structure that is not there, or one that is not finite
  explicit StructureLoads(const Spec& spec);

  /// Lets a load act with a share (1) of its size.
  void scale(std::size_t load, double share);
  /// Lets those that grow while the ground is in motion be as large as they are at a time of the simulation,
  /// s.
  void grow(double time);
  /// F on a structure, all loads together, N/m.
  const Vector& on(std::size_t structure) const { return on_[structure]; }

private:
  struct Load {
    std::size_t structure;
    Vector force; ///< of its full size, N/m
    std::optional<Growth> growth;
    double share = 1.0;
  };

  void add_up();

  std::vector<Load> loads_; ///< as in Spec::structure_loads
  std::vector<Vector> on_;  ///< by structure
};

/// Adds the loads on elastic bodies to the forces on their nodes.
void add_loads(const Contact& contact, Ground& ground);

/// The loads on structures in a step; none where there is nothing to do for them. Contact takes those on
/// rigid bodies.
std::vector<Pass> structure_load_passes(Ground& ground, Contact& contact);

} // namespace tremolo::mpm_domain
