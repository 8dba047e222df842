#pragma once

#include <cstddef>

namespace tremolo::mpm_domain {

/// A node, and how much of something is its own, 1.
struct NodeShare {
  std::size_t node;
  double share;
};

} // namespace tremolo::mpm_domain
