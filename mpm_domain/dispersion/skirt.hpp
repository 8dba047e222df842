#pragma once

// Differences at a node take values from up to three nodes away (sharpening.hpp, fullness.hpp), which may lie
// beyond all windows of a rank's tiles. There is a skirt of nodes around these, and around those near the
// boundary, at which each rank takes over values from the ranks that own them.

#include "mpm_domain/fields/node_fields.hpp"
#include "mpm_domain/ranks/shared_list.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

struct Ground;

class Skirt {
public:
  /// @param ground       of one lattice, which ranks share
  /// @param of_boundary  nodes that every rank computes
  Skirt(const Ground& ground, std::span<const std::size_t> of_boundary);

  /// The nodes of all skirts.
  std::span<const std::size_t> nodes() const { return nodes_; }
  /// These nodes take the values of some fields from their owners.
  void take(Ground& ground, std::span<NodeField NodeFields::*const> fields);

private:
  std::vector<std::size_t> nodes_;
  SharedList list_;
  std::vector<double> numbers_; ///< of a message
};

/// Lets the nodes of skirts take the values of some fields; does nothing in one process.
void take_at_skirt(Ground& ground, std::span<NodeField NodeFields::*const> fields);

} // namespace tremolo::mpm_domain
