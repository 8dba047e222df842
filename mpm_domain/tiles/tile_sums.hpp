#pragma once

// Every tile adds up the contributions of its particles in a window of its own: its nodes and a halo around
// them. Then every node adds up the windows that hold it, in the order of their tiles. No two threads write
// to the same number, and every sum has the same terms in the same order for any number of threads.
//
// The nodes of a tile take their sums as soon as the last window that holds any of them is filled. Once all
// nodes of a window have taken their sums, the window is used for another tile. So only few windows are in
// use at a time, and they stay in the cache.
//
// Where ranks share the domain, tiles of others whose windows hold nodes that this rank needs are tiles like
// its own, whose windows are filled by messages (halo.hpp). Nodes add them up in the same order.

#include "mpm_domain/fields/node_fields.hpp"
#include "mpm_domain/tiles/halo.hpp"
#include "mpm_domain/tiles/tile_map.hpp"
#include "mpm_domain/tiles/worker_pool.hpp"

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Keeps the windows that are not in use. Their sums are zero: [field of particle_sums][row][column].
class WindowPool {
public:
  /// Makes windows until there are `count`. More are made when they are needed.
  void reserve(std::size_t count);
  double* take();
  void give_back(double* window);

private:
  void make_one();

  std::mutex mutex_;
  std::vector<std::unique_ptr<double[]>> all_;
  std::vector<double*> free_;
};

/// The sums of the tiles that hold particles of one clock.
class TileSums {
public:
  /// @param filled     the tiles that hold particles of this rank, in rising order
  /// @param share      of this rank; null where there is one. It outlives this
  /// @param of_others  the tiles that hold particles of other ranks, rising
  TileSums(const TileMap& tiles, std::vector<std::size_t> filled, const RankShare* share = nullptr,
           std::span<const std::size_t> of_others = {});

  std::span<const std::size_t> filled() const { return filled_; }

  /// Adds the contributions of the particles of the n-th filled tile to a window whose sums are zero, and
  /// returns the rows of the lattice that they touch.
  using Fill = std::function<RowRange(std::size_t n, double* window)>;
  /// Calls `fill` for every filled tile and adds the sums of the given fields to the nodes.
  void add_to(NodeFields& nodes, std::span<const SumRange> fields, const TileMap& tiles, WorkerPool& workers,
              WindowPool& windows, const Fill& fill);
  void add_to(NodeFields& nodes, SumRange fields, const TileMap& tiles, WorkerPool& workers,
              WindowPool& windows, const Fill& fill) {
    add_to(nodes, std::span(&fields, 1), tiles, workers, windows, fill);
  }

private:
  /// A tile that owns nodes of some window, and the filled tiles whose windows may hold them, in rising order
  /// of the tiles.
  struct Owner {
    std::size_t tile;
    std::vector<std::size_t> from;
  };

  void find_owners(const TileMap& tiles, const RankShare* share);
  void take_sums(const Owner& owner, NodeFields& nodes, std::span<const SumRange> fields,
                 const TileMap& tiles);

  std::vector<std::size_t> filled_;
  std::optional<Halo> halo_;
  std::vector<Owner> owners_;
  // These have one entry a filled tile, then one for each of the halo's remote tiles:
  std::vector<std::vector<std::size_t>> owners_of_;
  std::vector<NodeBlock> positions_;      ///< nodes of its window
  std::vector<NodeBlock> touched_;        ///< the rows of the window that particles touch
  std::vector<double*> window_;           ///< its sums, until all owners have taken them
  std::vector<std::atomic<int>> to_take_; ///< number of owners that have not taken their sums yet
  // This has one entry an owner:
  std::vector<std::atomic<int>> to_fill_; ///< number of windows that are not filled yet
};

} // namespace tremolo::mpm_domain
