#pragma once

// Totals over parts of the domain, tiles and rows of nodes. Parts are the same for any number of threads and
// ranks, and their sums are added without rounding in between (exact_sum.hpp): so totals have the same bits.
//
// A rank sums up what counts on it. Totals of all ranks cost a wait, so those of a step, which go into the
// ledger alone, wait for one exchange at its end: they come with what is to be done with them.

#include "mpm_domain/ground.hpp"
#include "mpm_domain/ranks/exact_sum.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// Every number becomes its largest value over all ranks.
void take_largest(const Ground& ground, std::span<double> numbers);

/// Every node takes its value from the rank on which it counts; nodes that nobody has become zero. Does
/// nothing in one process.
void take_nodes_of_all(const Ground& ground, std::span<double> values);

/// The digits of sums become those over all ranks.
void add_over_ranks(const Ground& ground, std::span<ExactSum> sums);

/// Adds up the numbers of all parts of this rank.
template <std::size_t count>
ExactSums<count> sums_of(std::span<const std::array<double, count>> parts) {
  ExactSums<count> sums;
  for (const std::array<double, count>& part : parts)
    for (std::size_t i = 0; i < count; ++i)
      sums[i].add(part[i]);
  return sums;
}

/// Numbers that this rank alone knows; all others give zeros.
template <std::size_t count>
ExactSums<count> sums_of(const std::array<double, count>& numbers) {
  return sums_of(std::span<const std::array<double, count>>(&numbers, 1));
}

/// Runs `row_sum(nodes)` for all rows of nodes and adds up what it returns for those that count on this rank,
/// `count` numbers each.
template <std::size_t count, typename RowSum>
ExactSums<count> sum_over_rows(Ground& ground, std::span<const NodeRange> rows, const RowSum& row_sum) {
  std::vector<std::array<double, count>> sums(rows.size());
  ground.workers.run(sums.size(), [&](std::size_t row) {
    const std::array<double, count> sum = row_sum(rows[row]);
    if (ground.counts(rows[row]))
      sums[row] = sum;
  });
  return sums_of(std::span<const std::array<double, count>>(sums));
}

/// Keeps the bookings of a step in their order. In one process everything is booked at once.
class Bookings {
public:
  /// @param ranks  null where there is one process
  explicit Bookings(Communicator* ranks) : ranks_(ranks) {}

  /// Calls book(totals of all ranks).
  template <std::size_t count, typename Book>
  void add(const ExactSums<count>& sums, Book book) {
    if (ranks_ == nullptr)
      return book(values_of<count>(sums));
    const std::size_t first = sums_.size();
    sums_.insert(sums_.end(), sums.begin(), sums.end());
    waiting_.push_back([this, first, book = std::move(book)] {
      book(values_of<count>(std::span(sums_).subspan(first).template first<count>()));
    });
  }
  /// Calls book() after what has been added before.
  template <typename Book>
  void add(Book book) {
    add(ExactSums<0>{}, [book = std::move(book)](const std::array<double, 0>&) { book(); });
  }

  /// Exchanges and books all that waits, in one message; the numbers become the largest of all ranks. Does
  /// nothing in one process.
  void settle(std::span<double> largest);

private:
  template <std::size_t count>
  static std::array<double, count> values_of(std::span<const ExactSum, count> sums) {
    std::array<double, count> values;
    for (std::size_t i = 0; i < count; ++i)
      values[i] = sums[i].value();
    return values;
  }

  Communicator* ranks_;
  std::vector<ExactSum> sums_;
  std::vector<std::function<void()>> waiting_;
};

} // namespace tremolo::mpm_domain
