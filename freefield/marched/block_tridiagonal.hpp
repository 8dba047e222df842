#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <cstddef>
#include <vector>

namespace tremolo::freefield {

/// Block-tridiagonal matrix of Size x Size blocks, factored by Gaussian elimination without pivoting across
/// blocks; not necessarily symmetric.
template <int Size>
class BlockTridiagonal {
public:
  using Block = Eigen::Matrix<double, Size, Size>;

  explicit BlockTridiagonal(std::size_t blocks) : diagonal_(blocks), lower_(blocks - 1), upper_(blocks - 1) {}

  /// A block pair of the matrix: row i+1, column i is lower(i), row i, column i+1 is upper(i).
  Block& diagonal(std::size_t i) { return diagonal_[i]; }
  Block& lower(std::size_t i) { return lower_[i]; }
  Block& upper(std::size_t i) { return upper_[i]; }

  /// Replaces the matrix by its factors; not finite where the matrix is singular.
  void factor() {
    diagonal_[0] = diagonal_[0].inverse().eval();
    for (std::size_t i = 0; i + 1 < diagonal_.size(); ++i) {
      lower_[i] = lower_[i] * diagonal_[i];
      diagonal_[i + 1] = (diagonal_[i + 1] - lower_[i] * upper_[i]).inverse().eval();
      upper_[i] = diagonal_[i] * upper_[i];
    }
  }

  /// Solves for a right-hand side of Size values a block, in place, once factored.
  void solve(double* x) const {
    using Vector = Eigen::Vector<double, Size>;
    const auto block = [&](std::size_t i) { return Eigen::Map<Vector>(x + Size * i); };
    const std::size_t last = diagonal_.size() - 1;
    // Each loop carries one product from block to block; the diagonal's does not wait for it.
    Vector below = block(0);
    for (std::size_t i = 0; i < last; ++i) {
      const Vector here = block(i + 1) - lower_[i] * below;
      block(i) = diagonal_[i] * below;
      below = here;
    }
    Vector above = diagonal_[last] * below;
    block(last) = above;
    for (std::size_t i = last; i-- > 0;) {
      above = block(i) - upper_[i] * above;
      block(i) = above;
    }
  }

private:
  std::vector<Block> diagonal_, lower_, upper_;
};

} // namespace tremolo::freefield
