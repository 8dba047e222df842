#pragma once

// What some ranks need of others in every step: each gives the entries that it owns to those that want them,
// in one message between two ranks.

#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/ranks/listed_rows.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Entries of a list that go from one rank to another, as they stand until the list changes.
class Trade {
public:
  Trade() = default;
  /// All ranks call it.
  /// @param wanted    the entries that this rank needs of others
  /// @param owner_of  (entry) the rank that owns it
  template <typename OwnerOf>
  Trade(Communicator& ranks, std::span<const std::size_t> wanted, const OwnerOf& owner_of)
      : from_(static_cast<std::size_t>(ranks.size())), to_(from_.size()) {
    std::vector<std::vector<double>> told(from_.size());
    for (const std::size_t entry : wanted) {
      const auto owner = static_cast<std::size_t>(owner_of(entry));
      from_[owner].push_back(entry);
      told[owner].push_back(static_cast<double>(entry));
    }
    const std::vector<std::vector<double>> asked = ranks.swap(told);
    for (std::size_t rank = 0; rank < asked.size(); ++rank)
      for (const double entry : asked[rank])
        to_[rank].push_back(static_cast<std::size_t>(entry));
  }

  std::span<const std::size_t> from(std::size_t rank) const { return from_[rank]; }
  std::span<const std::size_t> to(std::size_t rank) const { return to_[rank]; }

private:
  std::vector<std::vector<std::size_t>> from_, to_; ///< by rank
};

/// Messages of a rank, by the rank that they go to or come from.
struct TradeMessages {
  std::vector<std::vector<double>> out, in;
};

/// All ranks give each other what the trades say.
/// @param messages  room for them
/// @param rows      ListedRows of Trades
template <typename... Rows>
void trade(Communicator& ranks, TradeMessages& messages, const Rows&... rows) {
  const auto count = static_cast<std::size_t>(ranks.size());
  messages.out.resize(count);
  messages.in.resize(count);
  for (std::size_t rank = 0; rank < count; ++rank) {
    messages.in[rank].resize(((rows.width * rows.list->from(rank).size()) + ...));
    if (!messages.in[rank].empty())
      ranks.receive(static_cast<int>(rank), messages.in[rank]);
  }
  for (std::size_t rank = 0; rank < count; ++rank) {
    std::vector<double>& out = messages.out[rank];
    out.resize(((rows.width * rows.list->to(rank).size()) + ...));
    double* next = out.data();
    ((next = read_entries(rows, rows.list->to(rank), next)), ...);
    if (!out.empty())
      ranks.send(static_cast<int>(rank), out);
  }
  ranks.wait();
  for (std::size_t rank = 0; rank < count; ++rank) {
    const double* next = messages.in[rank].data();
    ((next = write_entries(rows, rows.list->from(rank), next)), ...);
  }
}

} // namespace tremolo::mpm_domain
