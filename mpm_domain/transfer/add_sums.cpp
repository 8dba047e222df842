#include "mpm_domain/transfer/add_sums.hpp"

#include <vector>

namespace tremolo::mpm_domain {

// Each field is one task, so the order of the tiles is the same for any number of threads.
void add_across(Ground& ground, std::span<const AcrossTile> tiles, std::span<const SumRange> fields) {
  std::vector<std::size_t> sums;
  for (const SumRange& range : fields)
    for (std::size_t f = range.first; f < range.end; ++f)
      sums.push_back(f);
  ground.workers.run(sums.size(), [&](std::size_t task) {
    const std::size_t f = sums[task];
    NodeField& field = ground.grid.*particle_sums[f];
    for (const AcrossTile& tile : tiles) {
      const std::span<const std::uint32_t> fours = tile.weights.fours();
      const double* of_tile = &tile.sums[f * 4 * fours.size()];
      for (const std::uint32_t four : fours)
        for (const std::uint32_t node : ground.basis_cells.four(four).node)
          field[node] += *of_tile++;
    }
  });
}

} // namespace tremolo::mpm_domain
