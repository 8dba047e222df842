#pragma once

#include "mpm_domain/graded/box_average.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Weights of real nodes of consecutive particles whose boxes touch several lattices or a virtual node, or
/// are larger than half a cell. An affine velocity v_p + C (x - x_p) is told to nodes at their own places:
/// told to virtual ones and shared out, it would come to their real nodes as that of places in between, and a
/// linear field would be smoothed in every step.
class AcrossWeights {
public:
  /// Forgets all and starts with the weights of particle `first`.
  void restart(std::size_t first);
  /// The next particle's; each node, or image of one, stands once.
  void add(const GradedMesh& mesh, const mesh::Rectangle& box);

  /// Particles [first, end).
  std::size_t first() const { return first_; }
  std::size_t end() const { return first_ + start_.size() - 1; }

  std::span<const BoxWeight> of(std::size_t particle) const {
    const std::size_t n = particle - first_;
    return std::span(weights_).subspan(start_[n], start_[n + 1] - start_[n]);
  }

private:
  std::size_t first_ = 0;
  std::vector<std::size_t> start_{0};
  std::vector<BoxWeight> weights_;
};

} // namespace tremolo::mpm_domain
