#pragma once

#include "mpm_domain/grid/basis_cells.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Weights of four real nodes in the part of a particle's box that lies in one cell.
struct FourWeights {
  std::array<std::uint32_t, 4> node;
  std::uint32_t four;     ///< number in the table of cells, which knows where the nodes lie
  std::uint32_t position; ///< index of that four in AcrossWeights::fours()
  Lanes s;
  Lanes gx, gy; ///< 1/m
};

/// Reciprocals of the second moments of a particle's weights, 1/m2.
struct InverseMoments {
  double x = 0.0;
  double y = 0.0;
};

/// Weights of real nodes for consecutive particles whose boxes touch several lattices or a virtual node, or
/// are larger than half a cell. An affine velocity v_p + C (x - x_p) is evaluated at the positions of the
/// real nodes. If it were evaluated at virtual nodes and then shared out, real nodes would receive the
/// velocity of positions between them, and every step would smooth a linear field.
///
/// The cells that a box may touch are found once after a sort. In each step only the parts of the box in
/// these cells are computed again.
class AcrossWeights {
public:
  /// Forgets everything. The particles that follow begin with number `first`.
  void restart(std::size_t first);
  /// Finds the cells that the next particle's box may touch from now on.
  /// @param reach  all positions that the box may come to, m
  void expect(const GradedMesh& mesh, BasisCells& cells, const mesh::Rectangle& reach);
  /// Call after the last particle: gives the fours of all cells their indices in fours().
  void settle(const BasisCells& cells);

  /// Forgets the weights and keeps the cells.
  void clear();
  /// Computes the weights of the next particle. A node appears once for every part of the box that touches
  /// it.
  /// @returns whether all of the box lies in cells that were expected
  bool add(const BasisCells& cells, const mesh::Rectangle& box);

  /// Particles [first, end).
  std::size_t first() const { return first_; }
  std::size_t end() const { return first_ + cells_start_.size() - 1; }

  /// The fours of the table that the particles may touch, each once. Their order follows from the mesh and
  /// does not depend on when a cell was found.
  std::span<const std::uint32_t> fours() const { return fours_; }

  std::span<const FourWeights> of(std::size_t particle) const {
    const std::size_t n = particle - first_;
    return std::span(weights_).subspan(start_[n], start_[n + 1] - start_[n]);
  }
  const InverseMoments& per_moments(std::size_t particle) const { return per_moments_[particle - first_]; }

private:
  /// A cell of the table; the positions of its fours follow each other.
  struct TouchedCell {
    std::uint32_t number;
    std::uint32_t first_place;
  };

  std::size_t first_ = 0;
  std::vector<std::size_t> cells_start_{0};
  std::vector<TouchedCell> cells_;
  std::vector<std::uint32_t> fours_;
  std::vector<std::size_t> start_{0};
  std::vector<FourWeights> weights_;
  std::vector<InverseMoments> per_moments_;
};

} // namespace tremolo::mpm_domain
