#include "messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

namespace tremolo::cost {

namespace {

using mpm_domain::Communicator;

/// The least of several means over `repeats` calls, s.
double least_mean(Communicator& ranks, int repeats, const std::function<void()>& act) {
  using Clock = std::chrono::steady_clock;
  constexpr int means = 7;
  double least = std::numeric_limits<double>::infinity();
  for (int mean = 0; mean < means; ++mean) {
    double together = 0.0;
    ranks.largest({&together, 1});
    const Clock::time_point before = Clock::now();
    for (int i = 0; i < repeats; ++i)
      act();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - before).count() / repeats);
  }
  return least;
}

void print(const Communicator& ranks, std::string_view exchange, std::size_t bytes, double seconds) {
  if (ranks.rank() == 0)
    fmt::print("{},{},{},{:.4g}\n", exchange, ranks.size(), bytes, seconds);
}

/// From rank 0 to rank 1 and back.
void there_and_back(Communicator& ranks, std::vector<double>& out, std::vector<double>& in) {
  const int other = 1 - ranks.rank();
  if (ranks.rank() > 1)
    return;
  ranks.receive(other, in);
  if (ranks.rank() == 1)
    ranks.wait();
  ranks.send(other, out);
  ranks.wait();
}

/// Numbers that all ranks share, in equal parts.
std::vector<int> equal_parts(const Communicator& ranks, std::size_t numbers) {
  const auto count = static_cast<std::size_t>(ranks.size());
  std::vector<int> parts(count, static_cast<int>(numbers / count));
  parts.front() += static_cast<int>(numbers % count);
  return parts;
}

} // namespace

void time_messages(Communicator& ranks) {
  constexpr int repeats = 100;
  constexpr std::size_t largest_message = std::size_t{1} << 17; // numbers: 1 MiB
  constexpr std::size_t exact_sum = 67;                         // numbers of a total
  if (ranks.rank() == 0)
    fmt::print("exchange,ranks,bytes,seconds\n");
  for (std::size_t numbers = 1; numbers <= largest_message; numbers *= 4) {
    std::vector<double> out(numbers, 1.0);
    std::vector<double> in(numbers);
    if (ranks.size() > 1)
      print(ranks, "message", 8 * numbers,
            0.5 * least_mean(ranks, repeats, [&] { there_and_back(ranks, out, in); }));
    const std::vector<int> parts = equal_parts(ranks, numbers);
    print(ranks, "share", 8 * numbers, least_mean(ranks, repeats, [&] { ranks.share(out, parts); }));
    print(ranks, "follow_first", 8 * numbers, least_mean(ranks, repeats, [&] { ranks.follow_first(out); }));
  }
  for (const std::size_t numbers : {std::size_t{1}, exact_sum, 3 * exact_sum}) {
    std::vector<std::int64_t> sums(numbers, 0);
    print(ranks, "add", 8 * numbers, least_mean(ranks, repeats, [&] { ranks.add(sums); }));
  }
}

} // namespace tremolo::cost
