#pragma once

// Where a law yields, its particles see the mean change of volume of their cell,
//
//     de_xx, de_yy += (mean - d)/2,      d = de_xx + de_yy,      mean = sum V d / sum V
//
// over the cell's particles, and their own distortion: the F-bar method (de Souza Neto et al. 1996) for
// material points (Coombs et al. 2018). Each particle would otherwise ask its cell to keep its volume at a
// place of its own, which four nodes cannot do: soil that yields at constant volume, or is nearly
// incompressible, would be too stiff and far too strong. The mean is a projection that is self-adjoint with
// the volumes as weights, so that elastic soil gains no energy by it.
//
// The strains of a tile wait until the sums over cells are complete. A cell is the leaf that holds the
// particle's centre at the start of the step; its sums stand at its lower left node.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/strain_update.hpp"

namespace tremolo::mpm_domain {

inline constexpr SumRange cell_sums{static_cast<std::size_t>(Sum::cell_volume),
                                    static_cast<std::size_t>(Sum::cell_dilation) + 1};

/// Takes the strains of particles of one set, chunk by chunk.
class WaitingRange {
public:
  /// Of a tile on one lattice.
  /// @param window  of its sums
  WaitingRange(WaitingStrains& strains, const TileMap& tiles, std::size_t tile, double* window);
  /// Of particles across lattices, whose sums are added later.
  WaitingRange(WaitingStrains& strains, const GradedMesh& mesh);

  /// The cells of particles [first, first + count), before they move.
  void find_cells(const Particles& p, std::size_t first, std::size_t count);
  /// Their strains.
  void hold(const Particles& p, std::size_t first, std::size_t count, const Increments& increments);

private:
  WaitingStrains& strains_;
  const GradedMesh* mesh_ = nullptr;
  const Lattice* lattice_ = nullptr;
  NodeBlock place_; ///< of the window
  double* window_ = nullptr;
  std::array<std::size_t, strain_chunk_size> in_window_{};
};

/// Whether some set's law sees the mean of its cells.
bool some_wait(const Domain& domain);

/// Makes the sums over cells zero, and room for strains to wait.
void clear_cells(Domain& domain);

/// Stress, state and volume of the particles of a clock whose strains wait, after a step of dt (s).
GatherSums strain_by_cells(Domain& domain, int clock, double dt);

} // namespace tremolo::mpm_domain
