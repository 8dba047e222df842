#include "mpm_domain/tiles/halo.hpp"

#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace tremolo::mpm_domain {

namespace {

/// Columns and rows of a window that it shares with a neighbour.
constexpr int shared_nodes = window_columns - tile_columns;
static_assert(shared_nodes == window_rows - tile_rows);

/// Begin of A, B and C in a window of so many nodes, and the end.
constexpr std::array<int, 4> parts_of(int nodes) {
  return {0, shared_nodes, nodes - shared_nodes, nodes};
}

constexpr NodeBlock block_of(int piece) {
  const std::array<int, 4> columns = parts_of(window_columns);
  const std::array<int, 4> rows = parts_of(window_rows);
  const auto i = static_cast<std::size_t>(piece % 3);
  const auto j = static_cast<std::size_t>(piece / 3);
  return {columns[i], rows[j], columns[i + 1] - columns[i], rows[j + 1] - rows[j]};
}

constexpr int pieces_of_window = 9;

/// Pieces of the window of a tile that lie in that of another, as bits.
unsigned pieces_in(const TileMap& tiles, std::size_t tile, std::size_t other) {
  const NodeBlock window = tiles.window(tile);
  const NodeBlock common = overlap(window, tiles.window(other));
  unsigned pieces = 0;
  for (int piece = 0; piece < pieces_of_window; ++piece) {
    NodeBlock block = block_of(piece);
    block.column += window.column;
    block.row += window.row;
    if (!overlap(block, common).empty())
      pieces |= 1U << static_cast<unsigned>(piece);
  }
  return pieces;
}

} // namespace

void Halo::Direction::add(std::size_t tile, int rank, unsigned pieces_wanted) {
  const auto found = std::ranges::find(ranks, rank);
  const auto position = static_cast<std::size_t>(found - ranks.begin());
  if (found == ranks.end()) {
    ranks.push_back(rank);
    length.push_back(0);
  }
  for (int piece = 0; piece < pieces_of_window; ++piece) {
    if ((pieces_wanted >> static_cast<unsigned>(piece) & 1U) == 0)
      continue;
    const NodeBlock block = block_of(piece);
    pieces[tile].push_back({block, position, length[position]});
    const auto count = static_cast<std::size_t>(block.columns) * static_cast<std::size_t>(block.rows);
    length[position] += count;
    nodes += count;
  }
}

void Halo::Direction::resize(std::size_t fields) {
  numbers.resize(ranks.size());
  for (std::size_t r = 0; r < ranks.size(); ++r)
    numbers[r].resize(fields * length[r]);
}

Halo::Halo(const TileMap& tiles, std::span<const std::size_t> filled, std::span<const std::size_t> of_others,
           const RankShare& share)
    : share_(share) {
  const int me = share.ranks->rank();
  out_.pieces.resize(filled.size());
  for (std::size_t n = 0; n < filled.size(); ++n) {
    std::map<int, unsigned> wanted; // by rank
    for (const std::size_t other : tiles.around(filled[n]))
      if (const int owner = share.owner(other); owner != me && owner != Deal::nobody)
        wanted[owner] |= pieces_in(tiles, filled[n], other);
    for (const auto& [rank, pieces] : wanted)
      out_.add(n, rank, pieces);
    (wanted.empty() ? interior_ : rim_).push_back(n);
  }
  for (const std::size_t tile : of_others) {
    unsigned wanted = 0;
    for (const std::size_t other : tiles.around(tile))
      if (share.is_mine(other))
        wanted |= pieces_in(tiles, tile, other);
    if (wanted == 0)
      continue;
    remote_.push_back(tile);
    in_.pieces.emplace_back();
    in_.add(remote_.size() - 1, share.owner(tile), wanted);
    RowRange& rows = rows_.emplace_back();
    for (const Piece& piece : in_.pieces.back()) {
      const int first = tiles.window(tile).row + piece.block.row;
      rows.add({first, first + piece.block.rows});
    }
  }
}

void Halo::begin(std::span<const SumRange> fields) {
  fields_.clear();
  for (const SumRange& range : fields)
    for (std::size_t f = range.first; f < range.end; ++f)
      fields_.push_back(f);
  out_.resize(fields_.size());
  in_.resize(fields_.size());
  for (std::size_t r = 0; r < in_.ranks.size(); ++r)
    share_.ranks->receive(in_.ranks[r], in_.numbers[r]);
}

/// move(place in a window, place in the piece's part of the message, length) for every row and field.
template <typename Move>
void Halo::for_rows(const Piece& piece, const Move& move) const {
  std::size_t in_message = piece.offset * fields_.size();
  const auto length = static_cast<std::size_t>(piece.block.columns);
  for (const std::size_t field : fields_)
    for (int row = piece.block.row; row < piece.block.end_row(); ++row, in_message += length)
      move(field * window_nodes + static_cast<std::size_t>(row * window_columns + piece.block.column),
           in_message, length);
}

void Halo::pack(std::size_t n, const double* window) {
  for (const Piece& piece : out_.pieces[n]) {
    double* const message = out_.numbers[piece.rank].data();
    for_rows(piece, [&](std::size_t in_window, std::size_t in_message, std::size_t length) {
      std::copy_n(window + in_window, length, message + in_message);
    });
  }
}

void Halo::send() {
  for (std::size_t r = 0; r < out_.ranks.size(); ++r)
    share_.ranks->send(out_.ranks[r], out_.numbers[r]);
}

void Halo::wait() {
  share_.ranks->wait();
}

void Halo::unpack(std::size_t n, double* window) const {
  for (const Piece& piece : in_.pieces[n]) {
    const double* const message = in_.numbers[piece.rank].data();
    for_rows(piece, [&](std::size_t in_window, std::size_t in_message, std::size_t length) {
      std::copy_n(message + in_message, length, window + in_window);
    });
  }
}

} // namespace tremolo::mpm_domain
