#include "mpm_domain/tiles/totals.hpp"

#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace tremolo::mpm_domain {

namespace {

std::vector<std::int64_t> digits_of(std::span<ExactSum> sums) {
  std::vector<std::int64_t> digits;
  for (ExactSum& sum : sums)
    digits.insert(digits.end(), sum.parts().begin(), sum.parts().end());
  return digits;
}

void take_digits(const std::vector<std::int64_t>& digits, std::span<ExactSum> sums) {
  auto next = digits.begin();
  for (ExactSum& sum : sums) {
    std::copy_n(next, sum.parts().size(), sum.parts().begin());
    next += static_cast<std::ptrdiff_t>(sum.parts().size());
  }
}

} // namespace

void take_largest(const Ground& ground, std::span<double> numbers) {
  if (ground.share)
    ground.share->ranks->largest(numbers);
}

void take_nodes_of_all(const Ground& ground, std::span<double> values) {
  if (!ground.share)
    return;
  std::vector<std::int64_t> bits(values.size());
  for (std::size_t n = 0; n < values.size(); ++n)
    bits[n] = ground.counts({n, n + 1}) ? std::bit_cast<std::int64_t>(values[n]) : 0;
  ground.share->ranks->add(bits); // one rank has those of a node, and zeros add nothing
  for (std::size_t n = 0; n < values.size(); ++n)
    values[n] = std::bit_cast<double>(bits[n]);
}

void add_over_ranks(const Ground& ground, std::span<ExactSum> sums) {
  if (!ground.share)
    return;
  std::vector<std::int64_t> digits = digits_of(sums);
  ground.share->ranks->add(digits);
  take_digits(digits, sums);
}

void Bookings::settle(std::span<double> largest) {
  if (ranks_ == nullptr)
    return;
  std::vector<std::int64_t> digits = digits_of(sums_);
  ranks_->add_and_find_largest(digits, largest);
  take_digits(digits, sums_);
  for (const std::function<void()>& book : waiting_)
    book();
  sums_.clear();
  waiting_.clear();
}

} // namespace tremolo::mpm_domain
