#include "freefield/ode/ode_grid.hpp"

#include <algorithm>

namespace tremolo::freefield {
namespace {

/// Cuts the lowest layer into one half cell at the base and equal whole cells, one half cell more than it
/// has.
void insert_half_cell(ColumnMesh& mesh) {
  const std::size_t layer = mesh.element_layer.front();
  const auto cells =
      static_cast<std::size_t>(std::count(mesh.element_layer.begin(), mesh.element_layer.end(), layer));
  const double base = mesh.node_y.front();
  const double size = (mesh.node_y[cells] - base) / (static_cast<double>(cells) + 0.5);
  mesh.element_layer.insert(mesh.element_layer.begin(), layer);
  mesh.node_y.insert(mesh.node_y.begin(), base);
  for (std::size_t i = 1; i <= cells; ++i)
    mesh.node_y[i] = base + (static_cast<double>(i) - 0.5) * size;
}

} // namespace

StaggeredGrid staggered_grid(const Profile& profile, double max_cell_size, BaseKind base) {
  StaggeredGrid grid{mesh_profile(profile, max_cell_size), {}};
  if (base == BaseKind::compliant)
    insert_half_cell(grid.mesh);
  grid.stress_y.reserve(grid.mesh.elements());
  for (std::size_t e = 0; e < grid.mesh.elements(); ++e)
    grid.stress_y.push_back(0.5 * (grid.mesh.node_y[e] + grid.mesh.node_y[e + 1]));
  if (base == BaseKind::compliant)
    grid.stress_y.front() = grid.mesh.node_y.front();
  return grid;
}

} // namespace tremolo::freefield
