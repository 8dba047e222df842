#pragma once

#include "mpm_domain/boundary/boundary_faces.hpp"
#include "mpm_domain/fields/zero_pages.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The nodes that faces touch. Nodes of former steps may stay: no face gives them anything.
class FaceNodes {
public:
  /// Forgets all nodes of a grid of another size.
  /// @returns whether it did
  bool restart(std::size_t grid_size) {
    if (known_.size() == grid_size)
      return false;
    nodes_.clear();
    set_to_zeros(known_, grid_size);
    return true;
  }

  void add(std::span<const FaceWeights> weights) {
    const std::size_t before = nodes_.size();
    std::uint8_t* const known = known_.data();
    for (const FaceWeights& face : weights)
      for (const auto& [node, w] : face)
        if (known[node] == 0) [[unlikely]] {
          known[node] = 1;
          nodes_.push_back(node);
        }
    if (nodes_.size() > before)
      std::ranges::sort(nodes_);
  }

  /// Rising.
  std::span<const std::size_t> all() const { return nodes_; }

private:
  std::vector<std::size_t> nodes_;
  ZeroPages<std::uint8_t> known_; ///< by node: it is one of them
};

} // namespace tremolo::mpm_domain
