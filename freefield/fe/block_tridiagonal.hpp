#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <cstddef>
#include <vector>

namespace tremolo::freefield {

/// Block-tridiagonal matrix of 2 x 2 blocks, factored by Gaussian elimination without pivoting across blocks;
/// not necessarily symmetric.
class BlockTridiagonal {
public:
  explicit BlockTridiagonal(std::size_t blocks) : diagonal_(blocks), lower_(blocks - 1), upper_(blocks - 1) {}

  /// A block pair of the matrix: row i+1, column i is lower(i), row i, column i+1 is upper(i).
  Eigen::Matrix2d& diagonal(std::size_t i) { return diagonal_[i]; }
  Eigen::Matrix2d& lower(std::size_t i) { return lower_[i]; }
  Eigen::Matrix2d& upper(std::size_t i) { return upper_[i]; }

  /// Replaces the matrix by its factors; not finite where the matrix is singular.
  void factor() {
    diagonal_[0] = diagonal_[0].inverse().eval();
    for (std::size_t i = 0; i + 1 < diagonal_.size(); ++i) {
      lower_[i] = lower_[i] * diagonal_[i];
      diagonal_[i + 1] = (diagonal_[i + 1] - lower_[i] * upper_[i]).inverse().eval();
    }
  }

  /// Solves for a right-hand side of two values a block, in place, once factored.
  void solve(std::vector<double>& x) const {
    const auto block = [&](std::size_t i) { return Eigen::Map<Eigen::Vector2d>(x.data() + 2 * i); };
    const std::size_t last = diagonal_.size() - 1;
    for (std::size_t i = 0; i < last; ++i)
      block(i + 1) -= lower_[i] * block(i);
    block(last) = (diagonal_[last] * block(last)).eval();
    for (std::size_t i = last; i-- > 0;)
      block(i) = (diagonal_[i] * (block(i) - upper_[i] * block(i + 1))).eval();
  }

private:
  std::vector<Eigen::Matrix2d> diagonal_, lower_, upper_;
};

} // namespace tremolo::freefield
