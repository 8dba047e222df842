#include "mpm_domain/tiles/tile_sums.hpp"

#include "mpm_domain/kernel/lanes.hpp"

#include <algorithm>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

void move_four(double* from, double* to) {
  store(to, load(to) + load(from));
  store(from, Lanes{});
}

/// Adds one array to another and makes the first one zero. The last one to three numbers go one by one, which
/// is faster than masked stores.
void move_row(double* from, double* to, int count) {
  int i = 0;
  for (; i + 4 <= count; i += 4)
    move_four(from + i, to + i);
  for (; i < count; ++i) {
    to[i] += from[i];
    from[i] = 0.0;
  }
}

/// move_row() for a row as long as a tile.
void move_tile_row(double* from, double* to) {
  static_assert(tile_columns % 4 == 0);
#pragma GCC unroll 8
  for (int i = 0; i < tile_columns; i += 4)
    move_four(from + i, to + i);
}

/// Subtracts one.
/// @returns whether the count is now zero. The caller then sees everything that other threads wrote before
/// they subtracted theirs.
bool is_last(std::atomic<int>& count) {
  return count.fetch_sub(1, std::memory_order_acq_rel) == 1;
}

} // namespace

void WindowPool::reserve(std::size_t count) {
  const std::lock_guard lock(mutex_);
  while (all_.size() < count)
    make_one();
}

void WindowPool::make_one() {
  all_.push_back(std::make_unique<double[]>(particle_sums.size() * window_nodes));
  free_.push_back(all_.back().get());
}

double* WindowPool::take() {
  const std::lock_guard lock(mutex_);
  if (free_.empty())
    make_one();
  double* window = free_.back();
  free_.pop_back();
  return window;
}

void WindowPool::give_back(double* window) {
  const std::lock_guard lock(mutex_);
  free_.push_back(window);
}

TileSums::TileSums(const TileMap& tiles, std::vector<std::size_t> filled)
    : filled_(std::move(filled)), owners_of_(filled_.size()), touched_(filled_.size()),
      window_(filled_.size()), to_take_(filled_.size()) {
  std::vector<std::size_t> owners;
  for (const std::size_t tile : filled_) {
    places_.push_back(tiles.window(tile));
    const std::vector<std::size_t> around = tiles.around(tile);
    owners.insert(owners.end(), around.begin(), around.end());
  }
  std::ranges::sort(owners);
  const auto repeated = std::ranges::unique(owners);
  owners.erase(repeated.begin(), repeated.end());
  for (const std::size_t tile : owners) {
    Owner& owner = owners_.emplace_back(Owner{tile, {}});
    for (const std::size_t other : tiles.around(tile)) {
      const auto at = std::ranges::lower_bound(filled_, other);
      if (at == filled_.end() || *at != other)
        continue;
      owner.from.push_back(static_cast<std::size_t>(at - filled_.begin()));
      owners_of_[owner.from.back()].push_back(owners_.size() - 1);
    }
  }
  to_fill_ = std::vector<std::atomic<int>>(owners_.size());
}

void TileSums::add_to(NodeFields& nodes, std::span<const SumRange> fields, const TileMap& tiles,
                      WorkerPool& workers, WindowPool& windows, const Fill& fill) {
  for (std::size_t o = 0; o < owners_.size(); ++o)
    to_fill_[o] = static_cast<int>(owners_[o].from.size());
  for (std::size_t n = 0; n < filled_.size(); ++n)
    to_take_[n] = static_cast<int>(owners_of_[n].size());
  workers.run(filled_.size(), [&](std::size_t n) {
    window_[n] = windows.take();
    const RowRange rows = fill(n, window_[n]);
    touched_[n] = rows.begin < rows.end
                      ? NodeBlock{places_[n].column, rows.begin, window_columns, rows.end - rows.begin}
                      : NodeBlock{}; // no particle of this tile adds anything
    for (const std::size_t o : owners_of_[n]) {
      if (!is_last(to_fill_[o]))
        continue;
      take_sums(owners_[o], nodes, fields, tiles);
      for (const std::size_t from : owners_[o].from)
        if (is_last(to_take_[from]))
          windows.give_back(window_[from]);
    }
  });
}

void TileSums::take_sums(const Owner& owner, NodeFields& nodes, std::span<const SumRange> fields,
                         const TileMap& tiles) {
  const Lattice& lattice = tiles.lattice(tiles.level_of(owner.tile));
  const NodeBlock owned = tiles.owned(owner.tile);
  for (const std::size_t n : owner.from) {
    const NodeBlock part = overlap(owned, touched_[n]);
    if (part.empty())
      continue;
    const int first = (part.row - places_[n].row) * window_columns + part.column - places_[n].column;
    const std::size_t first_node = lattice.index(part.column, part.row);
    const auto move = [&](std::size_t f) {
      double* from = window_[n] + f * window_nodes + first;
      double* to = (nodes.*particle_sums[f]).data() + first_node;
      for (int j = 0; j < part.rows; ++j, from += window_columns, to += lattice.nx)
        part.columns == tile_columns ? move_tile_row(from, to) : move_row(from, to, part.columns);
    };
    for (const SumRange& range : fields)
      for (std::size_t f = range.first; f < range.end; ++f)
        move(f);
  }
}

} // namespace tremolo::mpm_domain
