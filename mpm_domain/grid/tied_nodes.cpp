#include "mpm_domain/grid/tied_nodes.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// act(field) for every field of a group, side by side.
template <typename Act>
void over_fields(Domain& domain, NodeGroup group, const Act& act) {
  if (domain.ties().empty())
    return;
  std::vector<NodeField*> fields;
  for_group(domain.grid, group, [&](NodeField& field) { fields.push_back(&field); });
  domain.workers.run(fields.size(), [&](std::size_t task) { act(*fields[task]); });
}

} // namespace

void clear(Domain& domain, NodeGroup group, std::span<const NodeRange> nodes) {
  domain.workers.run(nodes.size(), [&](std::size_t row) {
    for_group(domain.grid, group, [&](NodeField& field) {
      std::fill(field.data() + nodes[row].begin, field.data() + nodes[row].end, 0.0);
    });
  });
}

void fold(Domain& domain, NodeGroup group, std::span<const std::size_t> rows) {
  over_fields(domain, group, [&](NodeField& field) { domain.ties().restrict(field, rows); });
}

void prolong(Domain& domain, NodeGroup group, std::span<const std::size_t> rows) {
  over_fields(domain, group, [&](NodeField& field) { domain.ties().prolong(field, rows); });
}

void fold(Domain& domain, NodeGroup group) {
  over_fields(domain, group, [&](NodeField& field) { domain.ties().restrict(field); });
}

void prolong(Domain& domain, NodeGroup group) {
  over_fields(domain, group, [&](NodeField& field) { domain.ties().prolong(field); });
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
