#include "mpm_domain/water/seepage_force.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/transfer/add_sums.hpp"
#include "mpm_domain/transfer/scatter_kernel.hpp"

#include <algorithm>
#include <array>

namespace tremolo::mpm_domain {

namespace {

/// V j of a group of particles from k on, N/m
template <typename Group>
std::array<Lanes, 2> force_of(const Particles& p, std::size_t k, Group group) {
  const Lanes pull = -p.water->unit_weight * group.load(&p.volume[k]);
  return {pull * group.load(&p.head_slope_x[k]), pull * group.load(&p.head_slope_y[k])};
}

} // namespace

void follow_head(Ground& ground) {
  const std::size_t blocks = ground.block_count() + ground.across_block_count();
  ground.workers.run(blocks, [&](std::size_t block) {
    for (Particles& p : ground.sets)
      if (p.traits.seeping) {
        const ParticleRange range = p.in_block(block);
        follow_head(p, range.begin, range.end, *ground.head);
      }
  });
}

void scatter_seepage(Ground& ground, std::span<const NodeRange> nodes, std::span<const std::size_t> ties) {
  constexpr std::array fields{sums_between(Sum::seepage_x, Sum::seepage_y)};
  ground.workers.run(nodes.size(), [&](std::size_t row) {
    for (NodeField* field : {&ground.grid.seepage_x, &ground.grid.seepage_y})
      std::fill(field->data() + nodes[row].begin, field->data() + nodes[row].end, 0.0);
  });
  add_sums(
      ground, 0, fields,
      [&](const Particles& p, std::size_t tile, double* window) {
        if (!p.traits.seeping)
          return RowRange{};
        return scatter_scalars<2>(ground, p, 0, tile, window, Sum::seepage_x,
                                  [&](std::size_t k, auto group) { return force_of(p, k, group); });
      },
      [&](AcrossTile& tile) {
        const Particles& p = ground.sets[tile.set];
        add_across_tile(tile, fields.front(), [&](std::size_t k, const FourWeights& w, const auto& add) {
          if (!p.traits.seeping)
            return;
          const auto [x, y] = force_of(p, k, FewerThanFour(1));
          add(static_cast<std::size_t>(Sum::seepage_x), x[0] * w.s);
          add(static_cast<std::size_t>(Sum::seepage_y), y[0] * w.s);
        });
      });
  fold(ground, NodeGroup::seepage, ties);
}

void add_seepage(Ground& ground, std::span<const NodeRange> rows) {
  Grid& grid = ground.grid;
  ground.workers.run(rows.size(), [&](std::size_t row) {
    for (std::size_t n = rows[row].begin; n < rows[row].end; ++n) {
      grid.force_x[n] += grid.seepage_x[n];
      grid.force_y[n] += grid.seepage_y[n];
    }
  });
}

} // namespace tremolo::mpm_domain
