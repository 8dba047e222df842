#pragma once

// Masses, storage and drag of a column of soil with and without pore water, per m2 of plan area. Element e of
// length h joins nodes e and e+1; pore pressure p and effective stress are located at its centre, the
// velocities of solid and fluid at the nodes. An element in which water flows gives each of its nodes
//
//     m_s = (1-n) rho_s h/2,    m_f = n rho_f h/2,    m~_f = rho_f h/2,    r = (rho_f g/k) h/2,
//
// and the node has the porosity n_I = m_f/m~_f and the drag d = n_I r on the unit of fluid volume. Where
// water does not flow, grains and water are one mass, m_s = rho h/2. Grains do not compress and stay in their
// element: with h_0 and n_0 at rest
//
//     n = 1 - (1 - n_0) h_0/h,    Q = K_f/n,
//
// and m_s stays while m_f, m~_f and d follow n and h. In one dimension stress on horizontal planes is force
// per plan area whatever h is, so that the equations of motion of the nodes are those of any strain.

#include "freefield/column_mesh.hpp"
#include "freefield/profile.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::freefield {

/// One element at its present length.
struct WetElement {
  double length = 0.0;           ///< h, m
  double length_at_rest = 0.0;   ///< h_0, m
  double grain_share = 1.0;      ///< 1 - n_0, volume of grains over that of the element at rest
  double bulk_modulus = 0.0;     ///< K_f, Pa; 0 where no excess pore pressure arises
  double stiffness = 0.0;        ///< Q = K_f/n, Pa; 0 where no excess pore pressure arises
  double undrained_share = 0.0;  ///< Q/(M + Q) where there is pore water that does not flow; else 0
  double fluid_density = 0.0;    ///< rho_f of water that flows, kg/m3; else 0
  double fluid_share = 0.0;      ///< n rho_f of water that flows, kg/m3; else 0
  double solid_share = 0.0;      ///< what moves with the grains, kg/m3
  double given_resistance = 0.0; ///< rho_f g/k of water that flows, Pa s/m2; else 0
  double resistance = 0.0;       ///< the same in force, Pa s/m2
  double lowest_excess = 0.0;    ///< cavitation pressure less hydrostatic pressure, Pa
  double alpha = 0.0;            ///< mass-proportional damping, 1/s
  double beta = 0.0;             ///< stiffness-proportional damping, s
  double shear_ratio = 0.0;      ///< G/M
  double lateral_ratio = 0.0;    ///< lambda/M
  double density = 0.0;          ///< rho at rest, kg/m3

  /// n, where there is pore water
  double porosity() const { return 1.0 - grain_share * length_at_rest / length; }
  bool flows() const { return fluid_density > 0.0; }
};

/// One node at the present lengths of its elements.
struct WetNode {
  double solid = 0.0;        ///< m_s, kg/m2
  double fluid = 0.0;        ///< m_f, kg/m2; 0 where no water flows
  double full = 0.0;         ///< m~_f, kg/m2
  double drag = 0.0;         ///< d, Pa s/m
  bool sealed = false;       ///< no water passes: base, or soil or rock in which it does not flow
  double mass_damping = 0.0; ///< alpha times mass at rest, Pa s/m
  double dashpot_x = 0.0;    ///< half-space below and mass-proportional damping, Pa s/m
  double dashpot_y = 0.0;

  double porosity() const { return fluid > 0.0 ? fluid / full : 0.0; }
  double mass() const { return solid + fluid; }
};

struct WetGrid {
  std::vector<WetElement> elements; ///< from the base up
  std::vector<WetNode> nodes;
  double impedance_x = 0.0; ///< rho c_s of the half-space, Pa s/m; 0 over a rigid base
  double impedance_y = 0.0; ///< rho c_p
  double flow_speed = 1.0;  ///< how many times as easily as its soil says water flows, 1
};

WetGrid wet_grid(const Profile& profile, const ColumnMesh& mesh, const Damping& damping, bool compliant);

/// Gives the elements new lengths, and them and the nodes the porosities, masses and drag that follow. The
/// dashpots stay.
/// @param lengths  h of each element, m
void set_lengths(WetGrid& grid, const std::vector<double>& lengths);

/// Lets water flow so many times (1) as easily as its soil says.
void set_flow_speed(WetGrid& grid, double times);

} // namespace tremolo::freefield
