#pragma once

#include "freefield/column.hpp"
#include "freefield/column_mesh.hpp"
#include "freefield/profile.hpp"

#include <vector>

namespace tremolo::freefield {

/// Velocities at the nodes of a mesh, strains and stresses one a cell between them.
struct StaggeredGrid {
  ColumnMesh mesh;
  std::vector<double> stress_y; ///< where the stress of a cell stands, m
};

/// Stresses are located at the cells' centres. Over a rigid base the lowest node is the base. Over a
/// compliant one the lowest stress is located at the base itself, in a cell of half the length whose mass
/// belongs to the node above: the base's velocity then follows from stress and incident wave without a mass
/// of its own. With a mass it would be the stiffest equation of the column, by the impedance ratio of rock to
/// soil.
StaggeredGrid staggered_grid(const Profile& profile, double max_cell_size, BaseKind base);

} // namespace tremolo::freefield
