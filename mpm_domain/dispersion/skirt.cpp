#include "mpm_domain/dispersion/skirt.hpp"

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

namespace {

/// Second differences of second differences reach two nodes, the fullness around them two more.
constexpr int reach = 4;

/// Marks the nodes around a block of nodes.
template <typename Mark>
void mark_around(const Grid& grid, const NodeBlock& nodes, const Mark& mark) {
  const NodeBlock wide{nodes.column - reach, nodes.row - reach, nodes.columns + 2 * reach,
                       nodes.rows + 2 * reach};
  const NodeBlock inside = overlap(wide, {0, 0, grid.nx, grid.ny});
  for (int j = inside.row; j < inside.end_row(); ++j)
    for (int i = inside.column; i < inside.end_column(); ++i)
      mark(i, j);
}

} // namespace

Skirt::Skirt(const Ground& ground, std::span<const std::size_t> of_boundary) {
  const Grid& grid = ground.grid;
  const RankShare& share = *ground.share;
  std::vector<bool> is_wanted(grid.size(), false);
  for (std::size_t tile = 0; tile < ground.tiles.count(); ++tile)
    if (share.deal.load[tile] > 0)
      mark_around(grid, ground.tiles.window(tile), [&](int i, int j) {
        if (share.owner(ground.tiles.tile_of(0, i, j)) != share.owner(tile))
          is_wanted[grid.index(i, j)] = true;
      });
  for (const std::size_t node : of_boundary) {
    const NodePosition at = ground.position_of(node);
    mark_around(grid, {at.column, at.row, 1, 1}, [&](int i, int j) { is_wanted[grid.index(i, j)] = true; });
  }
  std::vector<int> owner;
  for (std::size_t node = 0; node < is_wanted.size(); ++node)
    if (is_wanted[node]) {
      const NodePosition at = ground.position_of(node);
      nodes_.push_back(node);
      owner.push_back(share.owner(ground.tiles.tile_of(0, at.column, at.row)));
    }
  list_ = SharedList(owner, *share.ranks);
}

void Skirt::take(Ground& ground, std::span<NodeField NodeFields::*const> fields) {
  NodeFields& grid = ground.grid;
  exchange_all(*ground.share->ranks, numbers_,
               ListedRows{&list_, fields.size(),
                          [&](std::size_t n, double* numbers) {
                            for (NodeField NodeFields::*const field : fields)
                              *numbers++ = (grid.*field)[nodes_[n]];
                          },
                          [&](std::size_t n, const double* numbers) {
                            for (NodeField NodeFields::*const field : fields)
                              (grid.*field)[nodes_[n]] = *numbers++;
                          }});
}

void take_at_skirt(Ground& ground, std::span<NodeField NodeFields::*const> fields) {
  if (ground.skirt)
    ground.skirt->take(ground, fields);
}

} // namespace tremolo::mpm_domain
