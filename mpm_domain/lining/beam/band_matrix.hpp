#pragma once

// A symmetric, positive definite matrix whose entries lie within w entries of the diagonal, and its Cholesky
// factors,
//
//     A = L D L^T,     D_j = A_jj - sum_k L_jk^2 D_k,     L_ij = (A_ij - sum_k L_ik D_k L_jk)/D_j,
//
// L_ii = 1, which has the same band (Golub and Van Loan 2013, section 4.3.5). A beam couples neighbours
// alone, and a closed one has that band as soon as its nodes are numbered from both sides of one of them: so
// some n w^2 operations suffice, without the ordering and the indices of a general sparse solver.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// A closed chain, taken alternately from both sides of the first: neighbours are two numbers apart at most.
std::vector<std::size_t> numbers_of_ring(std::size_t count);

class BandMatrix {
public:
  BandMatrix() = default;
  /// @param size   n
  /// @param width  w, entries beside the diagonal
  BandMatrix(std::size_t size, std::size_t width)
      : size_(size), width_(width), stride_(width + lanes), entries_(size * stride_, 0.0), inverse_(size) {}

  std::size_t size() const { return size_; }
  void clear() { std::ranges::fill(entries_, 0.0); }
  /// Adds to A_ij, and so to A_ji; i >= j.
  void add(std::size_t i, std::size_t j, double value) { at(i, j) += value; }

  /// Puts L and D in the place of A.
  /// @throws std::runtime_error if A is not positive definite
  void factorise();
  /// X = A^-1 X, after factorise().
  /// @param columns  of X, which stands in x row after row
  void solve(std::span<double> x, std::size_t columns = 1) const;

private:
  static constexpr std::size_t lanes = 4;

  /// The entry in row i and column j, i - w <= j <= i.
  double& at(std::size_t i, std::size_t j) { return entries_[i * stride_ + width_ + j - i]; }
  double at(std::size_t i, std::size_t j) const { return entries_[i * stride_ + width_ + j - i]; }
  /// The first column of a row that is within the band.
  std::size_t first(std::size_t i) const { return i > width_ ? i - width_ : 0; }
  template <class Group, class InMemory, std::size_t Count>
  void solve_groups(double* x, std::size_t stride) const;

  std::size_t size_ = 0;
  std::size_t width_ = 0;
  std::size_t stride_ = 0;      ///< a row up to the diagonal, and room behind it for a last group of lanes
  std::vector<double> entries_; ///< row after row
  std::vector<double> inverse_; ///< 1/D
};

} // namespace tremolo::mpm_domain
