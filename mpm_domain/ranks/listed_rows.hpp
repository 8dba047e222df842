#pragma once

#include <cstddef>
#include <span>

namespace tremolo::mpm_domain {

/// The numbers of the entries of a list that ranks exchange: of a SharedList or a Trade.
template <typename List, typename Read, typename Write>
struct ListedRows {
  const List* list;
  std::size_t width; ///< numbers of an entry
  Read read;         ///< (entry, numbers) gives those of an entry that this rank knows
  Write write;       ///< (entry, numbers) takes those of another
};
template <typename List, typename Read, typename Write>
ListedRows(const List*, std::size_t, Read, Write) -> ListedRows<List, Read, Write>;

/// Reads entries into a message.
/// @returns where it goes on
template <typename Rows>
double* read_entries(const Rows& rows, std::span<const std::size_t> entries, double* message) {
  for (const std::size_t entry : entries) {
    rows.read(entry, message);
    message += rows.width;
  }
  return message;
}

/// Writes entries from a message.
/// @returns where it goes on
template <typename Rows>
const double* write_entries(const Rows& rows, std::span<const std::size_t> entries, const double* message) {
  for (const std::size_t entry : entries) {
    rows.write(entry, message);
    message += rows.width;
  }
  return message;
}

} // namespace tremolo::mpm_domain
