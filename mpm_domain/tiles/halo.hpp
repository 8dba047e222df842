#pragma once

// The halo between ranks. A rank takes sums for all nodes in the windows of its tiles, so it needs what tiles
// of other ranks bring to these nodes. Windows overlap with those of the eight neighbours alone, in the
// columns A (5 nodes) and C (5 nodes) and in the rows A (5) and C (5) of this division of a window:
//
//        A |          B          | C
//        --+---------------------+--    C: in the windows of the upper neighbours too
//        A |     B: in none      | C    B: 27 columns, 3 rows
//        --+---------------------+--
//        A |          B          | C    A: in the windows of the left, or lower, neighbours too
//
// Each of the nine pieces goes once to every rank that owns a tile whose window it lies in, with the zeros in
// it: messages have the same length from one sort to the next. Between two ranks there is one message each
// way for each scatter. It is sent when the tiles at the rim are filled, and received behind the work in the
// interior.

#include "mpm_domain/fields/node_fields.hpp"
#include "mpm_domain/tiles/deal.hpp"
#include "mpm_domain/tiles/tile_map.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class Halo {
public:
  /// @param filled     the rank's own tiles with particles, rising
  /// @param of_others  those of other ranks, rising
  /// @param share      outlives this
  Halo(const TileMap& tiles, std::span<const std::size_t> filled, std::span<const std::size_t> of_others,
       const RankShare& share);

  /// Tiles of others whose windows hold nodes that this rank needs, rising.
  std::span<const std::size_t> remote() const { return remote_; }
  /// Own filled tiles, by their number among these, that other ranks need, and the rest.
  std::span<const std::size_t> rim() const { return rim_; }
  std::span<const std::size_t> interior() const { return interior_; }

  /// Numbers that go to, and come from, other ranks in an exchange of one field.
  std::size_t nodes_sent() const { return out_.nodes; }
  std::size_t nodes_received() const { return in_.nodes; }

  // The exchange of some fields, in this order:
  void begin(std::span<const SumRange> fields);
  void pack(std::size_t n, const double* window); ///< of the n-th filled tile, a tile of the rim
  void send();
  void wait();
  void unpack(std::size_t n, double* window) const;       ///< of the n-th remote tile, into a window of zeros
  RowRange rows(std::size_t n) const { return rows_[n]; } ///< that unpack() may touch

private:
  /// A piece of a window, and where it stands in the message to, or from, a rank.
  struct Piece {
    NodeBlock block;    ///< relative to the window
    std::size_t rank;   ///< which of `ranks`
    std::size_t offset; ///< in nodes
  };
  /// One direction: pieces by tile, and messages by rank.
  struct Direction {
    std::vector<std::vector<Piece>> pieces;
    std::vector<int> ranks;
    std::vector<std::size_t> length; ///< by rank, in nodes
    std::vector<std::vector<double>> numbers;
    std::size_t nodes = 0; ///< of all messages

    void add(std::size_t tile, int rank, unsigned pieces_wanted);
    void resize(std::size_t fields);
  };

  template <typename Move>
  void for_rows(const Piece& piece, const Move& move) const;

  const RankShare& share_;
  std::vector<std::size_t> remote_, rim_, interior_;
  std::vector<RowRange> rows_; ///< by remote tile
  Direction out_, in_;         ///< by filled tile; by remote tile
  std::vector<std::size_t> fields_;
};

} // namespace tremolo::mpm_domain
