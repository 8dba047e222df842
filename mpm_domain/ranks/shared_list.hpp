#pragma once

#include "mpm_domain/ranks/communicator.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// Entries of a list that all ranks have, of which each is known to one rank. share() tells it to all.
class SharedList {
public:
  SharedList() = default;
  /// @param owner  the rank that knows an entry, by entry; nobody: left out
  SharedList(const std::vector<int>& owner, Communicator& ranks) : ranks_(&ranks) {
    counts_.resize(static_cast<std::size_t>(ranks.size()));
    for (int rank = 0; rank < ranks.size(); ++rank)
      for (std::size_t entry = 0; entry < owner.size(); ++entry)
        if (owner[entry] == rank) {
          entries_.push_back(entry);
          ++counts_[static_cast<std::size_t>(rank)];
        }
    for (int rank = 0; rank < ranks.rank(); ++rank)
      own_ += static_cast<std::size_t>(counts_[static_cast<std::size_t>(rank)]);
  }

  static constexpr int nobody = -1;

  /// @param width  numbers of an entry
  /// @param read   (entry, numbers) gives those of an entry that this rank knows
  /// @param write  (entry, numbers) takes those of another
  template <typename Read, typename Write>
  void share(std::size_t width, const Read& read, const Write& write) {
    numbers_.resize(width * entries_.size());
    std::vector<int> lengths = counts_;
    for (int& length : lengths)
      length *= static_cast<int>(width);
    const auto mine = static_cast<std::size_t>(counts_[static_cast<std::size_t>(ranks_->rank())]);
    for (std::size_t i = own_; i < own_ + mine; ++i)
      read(entries_[i], &numbers_[width * i]);
    ranks_->share(numbers_, lengths);
    for (std::size_t i = 0; i < entries_.size(); ++i)
      if (i < own_ || i >= own_ + mine)
        write(entries_[i], &std::as_const(numbers_)[width * i]);
  }

private:
  Communicator* ranks_ = nullptr;
  std::vector<std::size_t> entries_; ///< those of rank 0, 1, ...
  std::vector<int> counts_;          ///< by rank
  std::size_t own_ = 0;              ///< where this rank's begin
  std::vector<double> numbers_;
};

} // namespace tremolo::mpm_domain
