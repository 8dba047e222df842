#include "mpm_domain/transfer/add_sums.hpp"

namespace tremolo::mpm_domain {

// Each field is one task, so the order of the tiles is the same for any number of threads.
void add_across(Domain& domain, std::span<const AcrossTile> tiles, SumRange fields) {
  domain.workers.run(fields.end - fields.first, [&](std::size_t task) {
    const std::size_t f = fields.first + task;
    NodeField& field = domain.grid.*particle_sums[f];
    for (const AcrossTile& tile : tiles) {
      const std::span<const std::uint32_t> fours = tile.weights.fours();
      const double* sums = &tile.sums[f * 4 * fours.size()];
      for (const std::uint32_t four : fours)
        for (const std::uint32_t node : domain.basis_cells.four(four).node)
          field[node] += *sums++;
    }
  });
}

} // namespace tremolo::mpm_domain
