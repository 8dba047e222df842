#include "mpm_domain/grid/tied_nodes.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// act(field) for every field of a group, side by side.
template <typename Act>
void over_fields(Ground& ground, NodeGroup group, const Act& act) {
  if (ground.ties().empty())
    return;
  std::vector<NodeField*> fields;
  for_group(ground.grid, group, [&](NodeField& field) { fields.push_back(&field); });
  ground.workers.run(fields.size(), [&](std::size_t task) { act(*fields[task]); });
}

} // namespace

void clear(Ground& ground, NodeGroup group, std::span<const NodeRange> nodes) {
  ground.workers.run(nodes.size(), [&](std::size_t row) {
    for_group(ground.grid, group, [&](NodeField& field) {
      std::fill(field.data() + nodes[row].begin, field.data() + nodes[row].end, 0.0);
    });
  });
}

void fold(Ground& ground, NodeGroup group, std::span<const std::size_t> rows) {
  over_fields(ground, group, [&](NodeField& field) { ground.ties().restrict(field, rows); });
}

void prolong(Ground& ground, NodeGroup group, std::span<const std::size_t> rows) {
  over_fields(ground, group, [&](NodeField& field) { ground.ties().prolong(field, rows); });
}

void fold(Ground& ground, NodeGroup group) {
  over_fields(ground, group, [&](NodeField& field) { ground.ties().restrict(field); });
}

void prolong(Ground& ground, NodeGroup group) {
  over_fields(ground, group, [&](NodeField& field) { ground.ties().prolong(field); });
}

Prolongation images_of(const Grid& grid) {
  Prolongation images;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (const int real = grid.real_column(i); real != i)
        images.tie(grid.index(i, j), std::array{Share{grid.index(real, j), 1.0, (real - i) * grid.h, 0.0}});
  return images;
}

} // namespace tremolo::mpm_domain
