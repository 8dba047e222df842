#pragma once

// What the particles of a tile bring to the nodes is summed up in a window of the tile's own, its nodes with
// a halo; then every node adds up the windows that hold it in the order of their tiles. No two threads write
// one number, and every sum has the same terms in the same order for any number of threads.
//
// Nodes take their sums as soon as the last of the windows that hold them is filled, and a window that all
// its nodes have taken is filled anew for another tile: so few windows are in use at a time, and they stay in
// the cache.

#include "mpm_domain/fields/node_fields.hpp"
#include "mpm_domain/tiles/tile_map.hpp"
#include "mpm_domain/tiles/worker_pool.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Fields [first, end) of the table of particle_sums.
struct SumRange {
  std::size_t first;
  std::size_t end;
};

/// Rows [begin, end) of a lattice.
struct RowRange {
  int begin = std::numeric_limits<int>::max();
  int end = std::numeric_limits<int>::min();

  void add(const RowRange& more) {
    begin = std::min(begin, more.begin);
    end = std::max(end, more.end);
  }
};

/// Windows of sums that are not in use, all zero: [field of particle_sums][row][column].
class WindowPool {
public:
  /// Makes so many windows at once; more are made when they are needed.
  void reserve(std::size_t count);
  double* take();
  void give_back(double* window);

private:
  void make_one();

  std::mutex mutex_;
  std::vector<std::unique_ptr<double[]>> all_;
  std::vector<double*> free_;
};

/// The tiles of one clock that hold particles.
class TileSums {
public:
  /// @param filled  in rising order
  TileSums(const TileMap& tiles, std::vector<std::size_t> filled);

  std::span<const std::size_t> filled() const { return filled_; }

  /// Adds what the particles of the n-th filled tile bring to a window that is zero, and returns the rows
  /// that they touch.
  using Fill = std::function<RowRange(std::size_t n, double* window)>;
  /// Adds what all tiles bring to the nodes.
  void add_to(NodeFields& nodes, SumRange fields, const TileMap& tiles, WorkerPool& workers,
              WindowPool& windows, const Fill& fill);

private:
  /// A tile with nodes that some window may hold, and the filled tiles with such windows, in rising order.
  struct Owner {
    std::size_t tile;
    std::vector<std::size_t> from;
  };

  void take_sums(const Owner& owner, NodeFields& nodes, SumRange fields, const TileMap& tiles);

  std::vector<std::size_t> filled_;
  std::vector<Owner> owners_;
  // by filled tile:
  std::vector<std::vector<std::size_t>> owners_of_;
  std::vector<NodeBlock> places_;         ///< of the window
  std::vector<NodeBlock> touched_;        ///< the rows of it that particles touch
  std::vector<double*> window_;           ///< while its sums are on their way to the nodes
  std::vector<std::atomic<int>> to_take_; ///< owners that have not taken their sums yet
  // by owner:
  std::vector<std::atomic<int>> to_fill_; ///< windows that are not filled yet
};

} // namespace tremolo::mpm_domain
