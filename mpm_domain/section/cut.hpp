#pragma once

// The forces that pass through a cut of an elastic body, from the equilibrium of what lies ahead of it. With
// chi_i the share of the cell around node i (a square of side h) that lies ahead of the cut, and f_i the
// nodal forces of the stress,
//
//     F = - sum_i chi_i f_i = sum_p V_p sigma_p sum_i chi_i grad S_i(x_p),
//     M_c = - sum_i chi_i (x_i - x_c) x f_i = sum_p V_p sum_i chi_i (x_i - x_c) x (sigma_p grad S_i(x_p)),
//
// is the force that what lies ahead exerts through the cut, and its moment about the middle of the cut: the
// section forces as finite elements have them, nodal forces added up on one side (Bathe 1996, section 4.2).
// As S_i adds up to one and to the position, particles among nodes of equal chi bring nothing, so that those
// within some two cells of the cut will do. By the motion of the nodes ahead,
//
//     F = sum_i chi_i (external and contact forces - m_i a_i),
//
// exactly, however uneven the stress of single particles is; M likewise. As the squares around the nodes
// tile the plane, the mean position of the cut is where it shall be, whatever its direction. With t from one
// end of the cut to the other and n to the left of it,
//
//     N = F . n,     Q = -F . t,     M = M_c,     dM/dn = -Q,
//
// signs as in linings (lining/beam/element.hpp). The cut goes with the particles next to it: x_c and its turn
// are those of the rigid motion that fits them best, as in contact/elastic_body.hpp.

#include "mpm_domain/spec/section.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

struct Lattice;
struct Particles;

/// Position of a cut.
struct CutPosition {
  Vector middle; ///< x_c, m
  Vector along;  ///< t
  double turn;   ///< since the start, counter-clockwise, rad

  Vector axis() const { return {-along.y, along.x}; } ///< n
};

class Cut {
public:
  /// @param line  where it is at the start
  /// @param sets  of the body's particles, at their positions of the start
  /// @param h     side of the body's cells, m
  /// @throws std::invalid_argument for a line without length, or one that no particles are next to
  Cut(const CutLine& line, std::span<const Particles> sets, double h);

  /// Its initial position.
  const CutLine& line() const { return line_; }
  /// @param sets  as before
  /// @param back  before the present time, s: particles are taken back along their velocities
  CutPosition position(std::span<const Particles> sets, double back = 0.0) const;
  /// @param lattice  of the body
  SectionForces forces(std::span<const Particles> sets, const Lattice& lattice) const;

private:
  /// A particle near the cut.
  struct Neighbour {
    std::size_t set;
    std::uint32_t id;
    Vector offset; ///< from the middle of the cut at the start, m
  };

  CutLine line_;
  double length_;
  std::vector<Neighbour> guides_;  ///< within a cell of the cut, which goes with them
  std::vector<Neighbour> bearing_; ///< all whose stress may pass through it
};

/// The share (1) of a square of side h around a point that lies ahead of a straight line.
/// @param ahead   signed distance of the point, m
/// @param normal  of the line
double share_ahead(double ahead, const Vector& normal, double h);

} // namespace tremolo::mpm_domain
