#pragma once

// A chain of beam elements (element.hpp), open or closed to a ring, with masses lumped at its nodes: each
// element gives each of its ends half of its mass and of its rotary mass. At a hinge the two elements have a
// turn theta each, so that no moment passes. Degrees of freedom are numbered node after node; nodes of a ring
// are taken alternately from both sides of the first, which keeps neighbours near each other
// (band_matrix.hpp).
//
// Positions q and velocities v belong to the times that places and velocities of particles belong to.

#include "mpm_domain/lining/beam/band_matrix.hpp"
#include "mpm_domain/lining/beam/element.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The initial nodes of a beam.
struct BeamShape {
  std::vector<Vector> nodes;            ///< of its axis, m
  bool closed = true;                   ///< whether the last is joined to the first
  std::vector<std::size_t> hinges = {}; ///< numbers of nodes
};

class Beam {
public:
  /// Creates the beam at rest and free of stress.
  /// @throws std::invalid_argument for fewer than two nodes (three of a ring), nodes that coincide, or a
  /// hinge that does not stand between two elements
  Beam(const BeamShape& shape, const BeamSection& section);

  const BeamSection& section() const { return section_; }
  std::size_t node_count() const { return first_dof_.size(); }
  /// Element k begins at node k.
  const std::vector<BeamElement>& elements() const { return elements_; }
  const ElementPosition& place_of_element(std::size_t element) const { return now_[element]; }
  std::span<const double> positions() const { return q_; } ///< m, rad
  std::span<const double> velocities() const { return v_; }
  std::span<const double> masses() const { return masses_; } ///< M, kg/m and kg m
  Vector position(std::size_t node) const { return {q_[first_dof_[node]], q_[first_dof_[node] + 1]}; }
  Vector velocity(std::size_t node) const { return {v_[first_dof_[node]], v_[first_dof_[node] + 1]}; }
  /// Its x; y and theta follow, at a hinge that of the element before it and then that of the one behind.
  std::size_t first_dof(std::size_t node) const { return first_dof_[node]; }

  double mass() const;           ///< kg/m
  double kinetic_energy() const; ///< J/m
  double strain_energy() const;  ///< J/m
  SectionForces forces(std::size_t element) const;
  /// f(q), what the elements take of the nodes: M dv/dt = -f.
  std::vector<double> internal_forces() const;
  /// Adds a multiple of K = B^T D B at the present position; its band is that of stiffness_band().
  void add_stiffness(double factor, BandMatrix& to) const;
  /// A matrix of zeros that holds M and K.
  BandMatrix empty_matrix() const;

  void set_velocities(std::span<const double> v);
  /// q += dt v.
  void move(double dt);
  /// Strains the elements by dt v, and leaves the nodes where they are.
  void strain_in_place(double dt);

  /// The variables of time q, v and e_0, for a checkpoint, and their restoration.
  std::vector<double> state() const;
  /// @throws std::runtime_error for the state of another beam
  void set_state(std::span<const double> state);

private:
  /// Finds where the elements are.
  void follow_positions();

  BeamSection section_;
  std::vector<std::size_t> first_dof_; ///< by node
  std::vector<BeamElement> elements_;
  std::vector<ElementPosition> now_; ///< of the elements
  std::vector<double> masses_, q_, v_;
};

} // namespace tremolo::mpm_domain
