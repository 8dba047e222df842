#pragma once

#include "freefield/column.hpp"
#include "freefield/column_mesh.hpp"
#include "freefield/twophase/wet_grid.hpp"

#include <vector>

namespace tremolo::freefield {

/// A two-phase column at one time: what it takes to say motion, stress and pore pressure anywhere in it.
struct WetSnapshot {
  struct Vector {
    double x = 0.0, y = 0.0;
  };

  Vector reference; ///< v_ref of base_motion.hpp, m/s
  // Values at the nodes.
  std::vector<Vector> u;       ///< displacement of the solid, m
  std::vector<Vector> v;       ///< velocity of the solid, m/s
  std::vector<Vector> a;       ///< acceleration of the solid, m/s2
  std::vector<Vector> a_fluid; ///< of the fluid; where none flows, of the solid
  std::vector<double> flux;    ///< Darcy flux n w, upwards, m/s
  std::vector<double> flux_x;  ///< and sideways
  // Values at the element centres in excess of the state at rest, Pa; stress effective, damping included.
  std::vector<double> sxx, syy, sxy;
  std::vector<double> pressure; ///< excess pore pressure, not below cavitation

  explicit WetSnapshot(std::size_t elements)
      : u(elements + 1), v(elements + 1), a(elements + 1), a_fluid(elements + 1), flux(elements + 1),
        flux_x(elements + 1), sxx(elements), syy(elements), sxy(elements), pressure(elements) {}
};

/// Stress and excess pore pressure at a place, Pa; total stress.
struct WetStress {
  double sxx = 0.0, syy = 0.0, sxy = 0.0, pressure = 0.0;
};

/// Between the centre of an element and its nodes by the equations of motion of the nearer node, so that both
/// elements at a node say the same, and a drained surface says zero.
WetStress stress_at(const WetSnapshot& snapshot, const ColumnMesh& mesh, const WetGrid& grid,
                    const ColumnMesh::Place& place);

/// Motion and strain at a place, without stress and rates.
ColumnSample motion_at(const WetSnapshot& snapshot, const ColumnMesh& mesh, const WetGrid& grid,
                       const ColumnMesh::Place& place);

} // namespace tremolo::freefield
