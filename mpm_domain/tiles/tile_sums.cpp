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

TileSums::TileSums(const TileMap& tiles, std::vector<std::size_t> filled, const RankShare* share,
                   std::span<const std::size_t> of_others)
    : filled_(std::move(filled)) {
  if (share != nullptr)
    halo_.emplace(tiles, filled_, of_others, *share);
  find_owners(tiles, share);
  const std::size_t count = owners_of_.size();
  touched_.resize(count);
  window_.resize(count);
  to_take_ = std::vector<std::atomic<int>>(count);
  to_fill_ = std::vector<std::atomic<int>>(owners_.size());
}

void TileSums::find_owners(const TileMap& tiles, const RankShare* share) {
  struct Filled {
    std::size_t tile;
    std::size_t n;
  };
  std::vector<Filled> all;
  for (const std::size_t tile : filled_)
    all.push_back({tile, all.size()});
  if (halo_)
    for (const std::size_t tile : halo_->remote())
      all.push_back({tile, all.size()});
  owners_of_.resize(all.size());
  for (const Filled& filled : all)
    positions_.push_back(tiles.window(filled.tile));
  std::ranges::sort(all, {}, &Filled::tile);

  std::vector<std::size_t> owners;
  const auto add_around = [&](std::size_t tile) {
    const std::vector<std::size_t> around = tiles.around(tile);
    owners.insert(owners.end(), around.begin(), around.end());
  };
  std::ranges::for_each(filled_, add_around);
  if (share != nullptr)
    for (std::size_t tile = 0; tile < tiles.count(); ++tile)
      if (share->is_mine(tile))
        add_around(tile);
  std::ranges::sort(owners);
  owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
  for (const std::size_t tile : owners) {
    Owner& owner = owners_.emplace_back(Owner{tile, {}});
    for (const std::size_t other : tiles.around(tile)) {
      const auto at = std::ranges::lower_bound(all, other, {}, &Filled::tile);
      if (at == all.end() || at->tile != other)
        continue;
      owner.from.push_back(at->n);
      owners_of_[at->n].push_back(owners_.size() - 1);
    }
  }
}

void TileSums::add_to(NodeFields& nodes, std::span<const SumRange> fields, const TileMap& tiles,
                      WorkerPool& workers, WindowPool& windows, const Fill& fill) {
  for (std::size_t o = 0; o < owners_.size(); ++o)
    to_fill_[o] = static_cast<int>(owners_[o].from.size());
  for (std::size_t n = 0; n < owners_of_.size(); ++n)
    to_take_[n] = static_cast<int>(owners_of_[n].size());
  const auto settle = [&](std::size_t n, const RowRange& rows) {
    touched_[n] = rows.begin < rows.end
                      ? NodeBlock{positions_[n].column, rows.begin, window_columns, rows.end - rows.begin}
                      : NodeBlock{}; // no particle of this tile adds anything
    for (const std::size_t o : owners_of_[n]) {
      if (!is_last(to_fill_[o]))
        continue;
      take_sums(owners_[o], nodes, fields, tiles);
      for (const std::size_t from : owners_[o].from)
        if (is_last(to_take_[from]))
          windows.give_back(window_[from]);
    }
  };
  const auto fill_one = [&](std::size_t n) {
    window_[n] = windows.take();
    return fill(n, window_[n]);
  };
  if (!halo_) {
    workers.run(filled_.size(), [&](std::size_t n) { settle(n, fill_one(n)); });
    return;
  }
  halo_->begin(fields);
  const std::span<const std::size_t> rim = halo_->rim();
  workers.run(rim.size(), [&](std::size_t i) {
    const RowRange rows = fill_one(rim[i]);
    halo_->pack(rim[i], window_[rim[i]]);
    settle(rim[i], rows);
  });
  halo_->send();
  const std::span<const std::size_t> interior = halo_->interior();
  workers.run(interior.size(), [&](std::size_t i) { settle(interior[i], fill_one(interior[i])); });
  halo_->wait();
  workers.run(halo_->remote().size(), [&](std::size_t r) {
    const std::size_t n = filled_.size() + r;
    window_[n] = windows.take();
    halo_->unpack(r, window_[n]);
    settle(n, halo_->rows(r));
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
    const int first = (part.row - positions_[n].row) * window_columns + part.column - positions_[n].column;
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
