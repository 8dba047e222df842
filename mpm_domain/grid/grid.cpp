#include "mpm_domain/grid/grid.hpp"

namespace tremolo::mpm_domain {

void resize(Grid& grid, int nx, int ny) {
  grid.nx = nx;
  grid.ny = ny;
  resize_fields(grid, grid.count());
}

void resize_fields(Grid& grid, std::size_t count) {
  for (const NodeFieldDescription& line : node_field_table)
    if (grid.traits.have(line.trait))
      set_to_zeros(grid.*line.field, count);
}

} // namespace tremolo::mpm_domain
