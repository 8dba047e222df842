#pragma once

#include "mpm_domain/ranks/communicator.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace tremolo::mpm_domain {

/// Every rank takes the lists of all, those of ranks 0, 1, ... one behind the other. All ranks call it.
inline std::vector<double> lists_of_all(Communicator& ranks, const std::vector<double>& own) {
  std::vector<std::int64_t> sizes(static_cast<std::size_t>(ranks.size()), 0);
  sizes[static_cast<std::size_t>(ranks.rank())] = static_cast<std::int64_t>(own.size());
  ranks.add(sizes);
  std::vector<double> all;
  for (int rank = 0; rank < ranks.size(); ++rank)
    if (rank == ranks.rank())
      all.insert(all.end(), own.begin(), own.end());
    else
      all.resize(all.size() + static_cast<std::size_t>(sizes[static_cast<std::size_t>(rank)]));
  ranks.share(all, std::vector<int>(sizes.begin(), sizes.end()));
  return all;
}

/// Likewise lists of records, which travel byte by byte: all ranks are of one build.
template <typename Record>
std::vector<Record> lists_of_all(Communicator& ranks, const std::vector<Record>& own) {
  static_assert(std::is_trivially_copyable_v<Record> && sizeof(Record) % sizeof(double) == 0);
  constexpr std::size_t width = sizeof(Record) / sizeof(double);
  std::vector<double> numbers(own.size() * width);
  if (!own.empty())
    std::memcpy(numbers.data(), own.data(), own.size() * sizeof(Record));
  numbers = lists_of_all(ranks, numbers);
  std::vector<Record> all(numbers.size() / width);
  if (!all.empty())
    std::memcpy(static_cast<void*>(all.data()), numbers.data(), all.size() * sizeof(Record));
  return all;
}

} // namespace tremolo::mpm_domain
