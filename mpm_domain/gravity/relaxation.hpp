#pragma once

// Damped relaxation of a domain whose particles keep their positions (gravity_stage.hpp):
//
//     m_i dv_i/dt = f_i + (1 - s) c_i - alpha m_i v_i,      s(t) = (1 - cos(pi t/T))/2,
//
// with base nodes fixed and side nodes free along the side. c_i is a load that holds the nodes at first and
// goes to zero as s goes to 1; loads and weights that come onto the ground grow with s.
//
// Ranks may share the domain; structures, linings, props and loads on the surface are then with the first.
//
// Soil carries no more than its strength, but does not soften. Structures stick to the soil where they are
// bonded. Where pore water cannot drain, its pressure follows the change of volume (water/pore_pressure.hpp);
// elsewhere it stays what it is.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// The course of a relaxation: what changes during it, and what ends it.
struct Course {
  bool bonded = false;                         ///< structures stick to the soil, whatever that takes
  UndrainedSoils undrained = {};               ///< their pore water moves with the grains
  double ramp = 0.0;                           ///< T, s; 0: nothing grows
  std::function<void(double share)> grow = {}; ///< brings what grows to a share s of its size
  double time = 0.0;                           ///< s within which all must rest, the ramp included
  double residual = 1e-9;                      ///< unbalanced over applied force of a domain at rest
  double skin = 0.0;    ///< unbalanced forces less deep than this below the surface do not count, in cells
  double falling = 0.0; ///< time is doubled while the residual is below this share of that half-way, 1
  long first = 0;       ///< number of the first step, for reports
};

/// State at the end of a relaxation.
struct Relaxed {
  long step;
  double residual;
};

class Relaxation {
public:
  /// Laws lose their softening, and soil its viscous damping, until finish().
  explicit Relaxation(Domain& domain);

  /// Gives the nodes the forces of soil, elastic bodies and loads as they are, without contact.
  void find_forces();
  /// These forces, N/m, on the nodes of all ranks.
  std::vector<Vector> forces();
  /// Sets the load c that holds the nodes until something has grown.
  void hold(std::vector<Vector> load) { held_ = std::move(load); }

  /// Goes on until all rests, or time is over.
  Relaxed run(const Course& course, const GravityProgress& progress);
  /// Length of a step of the last course, s.
  double step() const { return dt_; }
  /// Time that forces act for in it, with the damping, s.
  double kick() const { return dt_ / (1.0 + 0.5 * alpha_ * dt_); }
  /// Counts the motion of the soil as displacement from now on.
  void count_way();

  /// Displacements of the rigid structures since then.
  const std::vector<StructureWay>& structure_ways() const { return structure_ways_; }

  /// Gives laws and damping back what they have lost, and particles their displacement.
  void finish();
  /// Reactions of the constraints at the end, on the nodes of all ranks.
  Reactions reactions() const;

private:
  /// The fixed directions of each node, and the nodes that carry soil.
  struct Supports {
    ZeroPages<unsigned char> fixed_x, fixed_y, full;
    ZeroPages<unsigned char> met;  ///< nodes that structures touch
    ZeroPages<unsigned char> skin; ///< nodes whose unbalanced force does not count
  };

  void stop_nodes();
  void find_supports();
  void find_supports(const Lattice& lattice);
  void find_met_nodes();
  void find_skin(double cells);
  void add_held(double share);
  double relax_grid(bool bonded);
  void strain(bool undrained);
  void add_way();
  void take_way_as_displacement();

  Domain& domain_;
  bool has_structures_;               ///< this rank computes them
  std::vector<materials::Law> laws_;  ///< by set, with their softening
  std::vector<ParticleFields> given_; ///< by set: volumes and boxes, which stay
  Supports supports_;
  Reactions held_by_;        ///< nodes of the constraints
  std::vector<Vector> held_; ///< c; empty: none
  NodeField way_x_, way_y_;  ///< of nodes since it counts, m; empty: it does not
  std::vector<StructureWay> structure_ways_;
  double alpha_ = 0.0;
  double drained_step_ = 0.0; ///< s
  double dt_ = 0.0;           ///< of the present course, s
};

} // namespace tremolo::mpm_domain
