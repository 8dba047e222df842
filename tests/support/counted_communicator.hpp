#pragma once

// A communicator that passes everything on to another and counts it: how often ranks wait for all others, and
// how much they tell each other then. Communicator::traffic() counts messages between two ranks.

#include "mpm_domain/ranks/communicator.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tremolo::test_support {

class CountedCommunicator : public mpm_domain::Communicator {
public:
  /// What ranks do together, and wait(), which ends what send() and receive() have begun.
  enum class Kind { wait, add, largest, totals, share, follow_first, deal_out, collect, swap };
  static constexpr std::array<std::string_view, 9> names = {
      "wait", "add", "largest", "totals", "share", "follow_first", "deal_out", "collect", "swap"};

  struct Count {
    std::uint64_t calls = 0;
    std::uint64_t bytes = 0; ///< of the numbers that all ranks have afterwards
    double seconds = 0.0;    ///< that this rank was in them, its wait for others included
  };

  /// @param ranks  outlives this
  explicit CountedCommunicator(mpm_domain::Communicator& ranks) : ranks_(ranks) {}

  const Count& of(Kind kind) const { return counts_[static_cast<std::size_t>(kind)]; }

  int rank() const override { return ranks_.rank(); }
  int size() const override { return ranks_.size(); }

  void send(int to, std::span<const double> numbers) override {
    count(numbers);
    ranks_.send(to, numbers);
  }
  void receive(int from, std::span<double> numbers) override { ranks_.receive(from, numbers); }
  void wait() override {
    timed(Kind::wait, 0, [&] { ranks_.wait(); });
  }
  void add(std::span<std::int64_t> numbers) override {
    timed(Kind::add, numbers.size_bytes(), [&] { ranks_.add(numbers); });
  }
  void largest(std::span<double> numbers) override {
    timed(Kind::largest, numbers.size_bytes(), [&] { ranks_.largest(numbers); });
  }
  void add_and_find_largest(std::span<std::int64_t> sums, std::span<double> largest) override {
    timed(Kind::totals, sums.size_bytes() + largest.size_bytes(),
          [&] { ranks_.add_and_find_largest(sums, largest); });
  }
  void share(std::span<double> numbers, std::span<const int> counts) override {
    timed(Kind::share, numbers.size_bytes(), [&] { ranks_.share(numbers, counts); });
  }
  void follow_first(std::span<double> numbers) override {
    timed(Kind::follow_first, numbers.size_bytes(), [&] { ranks_.follow_first(numbers); });
  }
  void deal_out(std::span<const double> numbers, std::span<const int> counts,
                std::span<double> part) override {
    timed(Kind::deal_out, numbers.size_bytes(), [&] { ranks_.deal_out(numbers, counts, part); });
  }
  void collect(std::span<const double> part, std::span<const int> counts,
               std::span<double> numbers) override {
    timed(Kind::collect, numbers.size_bytes(), [&] { ranks_.collect(part, counts, numbers); });
  }
  std::vector<std::vector<double>> swap(const std::vector<std::vector<double>>& lists) override {
    std::vector<std::vector<double>> received;
    timed(Kind::swap, 0, [&] { received = ranks_.swap(lists); });
    return received;
  }

private:
  template <typename Act>
  void timed(Kind kind, std::size_t bytes, const Act& act) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point before = Clock::now();
    act();
    Count& count = counts_[static_cast<std::size_t>(kind)];
    ++count.calls;
    count.bytes += bytes;
    count.seconds += std::chrono::duration<double>(Clock::now() - before).count();
  }

  mpm_domain::Communicator& ranks_;
  std::array<Count, names.size()> counts_;
};

} // namespace tremolo::test_support
