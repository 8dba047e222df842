#pragma once

// Where a law yields, its particles see the mean change of volume of their cell,
//
//     de_xx, de_yy += (mean - d)/2,      d = de_xx + de_yy,      mean = sum V d / sum V
//
// over the cell's particles, and their own distortion: the F-bar method (de Souza Neto et al. 1996) for
// material points (Coombs et al. 2018). Otherwise every particle would require that the volume is constant at
// its own place, and the four nodes of a cell cannot satisfy so many constraints: soil that yields at
// constant volume, or is nearly incompressible, would be too stiff and far too strong. With the volumes as
// weights, the mean is a self-adjoint projection, so elastic soil gains no energy by it.
//
// The strains of a step are stored until the sums over all cells (cell_means.hpp) are complete; only then the
// laws see them. Cells are those of the particles at the start of the step. Particles of different clocks
// have means of their own.

#include "mpm_domain/ground.hpp"
#include "mpm_domain/strain/gather_sums.hpp"
#include "mpm_domain/strain/strain_update.hpp"
#include "mpm_domain/tiles/cell_means.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// Stores the strains of particles of one set, chunk by chunk, and adds them to the sums of their cells.
class WaitingRange {
public:
  /// The range for the particles of a tile that touch its lattice alone.
  /// @param window  takes the tile's sums
  WaitingRange(WaitingStrains& strains, const TileMap& tiles, std::size_t tile, double* window);
  /// The range for particles that touch several lattices; strain_by_cells() adds them to the sums.
  WaitingRange(WaitingStrains& strains, const GradedMesh& mesh);

  /// Finds the cells of particles [first, first + count). Call it before they move.
  void find_cells(const Particles& p, std::size_t first, std::size_t count);
  /// Stores the strain increments of these particles.
  void hold(const Particles& p, std::size_t first, std::size_t count, const Increments& increments);

private:
  WaitingStrains& strains_;
  CellFinder finder_;
  double* window_ = nullptr;
  std::array<std::size_t, strain_chunk_size> in_window_{}; ///< where the sums of each particle's cell stand
};

/// Whether the law of any set sees the mean dilatation of cells.
bool some_wait(const Ground& ground);

/// Sets the sums over cells to zero and makes room for the strains of all particles.
void clear_strains(Ground& ground);

/// Updates stress, state and volume of the particles of a clock whose strains over a step of dt (s) have been
/// stored.
/// @returns sums over parts of the particles, the same for any number of threads
std::vector<GatherSums> strain_by_cells(Ground& ground, int clock, double dt);

} // namespace tremolo::mpm_domain
