#pragma once

// Tied nodes have no motion of their own: their velocities are means of real nodes' velocities, v = P v_real,
// and what particles bring to them belongs to those nodes, m_real += P^T m (mass, momentum and force alike).
// Rows of P sum to one and P x_real = x, so that uniform and linear fields pass unchanged.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// A node and its share in a tied one, and where it lies from that (of a periodic mesh, its nearest image),
/// m.
struct Share {
  std::size_t node = 0;
  double weight = 0.0;
  double dx = 0.0;
  double dy = 0.0;
};

/// The sparse prolongation P; nodes that are not tied have no row and keep their values.
class Prolongation {
public:
  /// Ties a node to real ones. A node is tied once.
  void tie(std::size_t node, std::span<const Share> to);

  std::size_t tied_count() const { return tied_.size(); }
  bool empty() const { return tied_.empty(); }
  std::size_t tied(std::size_t row) const { return tied_[row]; }
  std::span<const Share> row(std::size_t row) const {
    return std::span(shares_).subspan(start_[row], start_[row + 1] - start_[row]);
  }

  /// The row of a node; empty if it is not tied.
  std::span<const Share> shares_of(std::size_t node) const;

  /// Its number; none if the node is not tied.
  std::optional<std::size_t> row_of(std::size_t node) const;

  /// field[tied] = sum of shares of field[real]: P, for velocities and accelerations.
  void prolong(std::span<double> field) const;
  void prolong(std::span<double> field, std::span<const std::size_t> rows) const;
  /// field[real] += shares of field[tied], which becomes zero: P^T, for mass, momentum and force.
  void restrict(std::span<double> field) const;
  void restrict(std::span<double> field, std::span<const std::size_t> rows) const;

private:
  void prolong_row(std::span<double> field, std::size_t row) const;
  void restrict_row(std::span<double> field, std::size_t row) const;

  std::vector<std::size_t> tied_;
  std::vector<std::size_t> rows_; ///< by node: 1 + its row, 0 if it has none
  std::vector<std::size_t> start_{0};
  std::vector<Share> shares_;
};

} // namespace tremolo::mpm_domain
