#pragma once

// Totals over parts of the domain, tiles and rows of nodes. Parts are the same for any number of threads and
// ranks, and their sums are added without rounding in between (exact_sum.hpp): so totals have the same bits.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/ranks/exact_sum.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Adds up over ranks.
void add_over_ranks(const Domain& domain, std::span<ExactSum> sums);

/// The largest, or least, of the numbers of all ranks.
double largest_of_ranks(const Domain& domain, double number);
double least_of_ranks(const Domain& domain, double number);

/// Adds up the numbers of all parts on all ranks.
template <std::size_t count>
std::array<double, count> totals(const Domain& domain, std::span<const std::array<double, count>> parts) {
  std::array<ExactSum, count> sums;
  for (const std::array<double, count>& part : parts)
    for (std::size_t i = 0; i < count; ++i)
      sums[i].add(part[i]);
  add_over_ranks(domain, sums);
  std::array<double, count> values;
  for (std::size_t i = 0; i < count; ++i)
    values[i] = sums[i].value();
  return values;
}

/// Runs `row_sum(nodes)` for all rows of nodes and adds up what it returns for those that count on this rank,
/// `count` numbers each.
template <std::size_t count, typename RowSum>
std::array<double, count> sum_over_rows(Domain& domain, std::span<const NodeRange> rows,
                                        const RowSum& row_sum) {
  std::vector<std::array<double, count>> sums(rows.size());
  domain.workers.run(sums.size(), [&](std::size_t row) {
    const std::array<double, count> sum = row_sum(rows[row]);
    if (domain.counts(rows[row]))
      sums[row] = sum;
  });
  return totals(domain, std::span<const std::array<double, count>>(sums));
}

} // namespace tremolo::mpm_domain
