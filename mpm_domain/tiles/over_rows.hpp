#pragma once

#include "mpm_domain/domain.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Runs `row_sum(nodes)` for all rows of nodes; the results stand in the order of the rows, to be added in it
/// for the same bits with any thread count.
template <typename Sum, typename RowSum>
std::vector<Sum> over_rows(Domain& domain, std::span<const NodeRange> rows, const RowSum& row_sum) {
  std::vector<Sum> sums(rows.size());
  domain.workers.run(sums.size(), [&](std::size_t row) { sums[row] = row_sum(rows[row]); });
  return sums;
}

} // namespace tremolo::mpm_domain
