#pragma once

// Cells of a graded mesh have the side h_l = h/2^l on level l, where h is the side of the root cells. Points
// whose coordinates were rounded lie on the lines between cells to a small part of that side.

namespace tremolo::mesh {

/// Side h_l of the cells of a level, m.
constexpr double cell_size(double root_size, int level) {
  return root_size / static_cast<double>(1 << level);
}

/// How far a point or an edge that lies on a line may be from it, m.
constexpr double alignment_tolerance(double size) {
  return 1e-6 * size;
}

} // namespace tremolo::mesh
