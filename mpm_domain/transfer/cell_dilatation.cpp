#include "mpm_domain/transfer/cell_dilatation.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

double* sums_of(Sum sum, double* window) {
  return window + static_cast<std::size_t>(sum) * window_nodes;
}

/// The lower left node of the leaf that holds a point.
std::size_t leaf_at(const GradedMesh& mesh, double x, double y) {
  std::size_t node = 0;
  mesh.for_parts({x, y, x, y}, [&](const mesh::Cell& cell, const mesh::Rectangle&) {
    const bool is_leaf = mesh.tree().exists(cell);
    node = is_leaf ? mesh.node(cell.level, cell.i, cell.j)
                   : mesh.node(cell.level - 1, cell.i / 2, cell.j / 2); // a quarter of one
  });
  return node;
}

/// Adds the particles that touch several lattices to the sums of their cells. They are few, so one thread
/// does it.
void add_across(Domain& domain, const ClockTiles& tiles) {
  for (const AcrossTile& tile : tiles.across) {
    const Particles& p = domain.sets[tile.set];
    if (!p.traits.cell_dilatation)
      continue;
    const WaitingStrains& strains = domain.waiting_strains[tile.set];
    for (std::size_t k = tile.weights.first(); k < tile.weights.end(); ++k) {
      domain.grid.cell_volume[strains.cell[k]] += p.volume[k];
      domain.grid.cell_dilation[strains.cell[k]] += p.volume[k] * (strains.exx[k] + strains.eyy[k]);
    }
  }
}

GatherSums strain_range(Domain& domain, std::size_t s, const ParticleRange& range, double dt) {
  Particles& p = domain.sets[s];
  const WaitingStrains& strains = domain.waiting_strains[s];
  LaneSums sums;
  Increments moved{}; // lanes beyond the last particle are read, and count nothing
  Increments seen{};
  for (std::size_t first = range.begin; first < range.end; first += strain_chunk_size) {
    const std::size_t count = std::min(strain_chunk_size, range.end - first);
    for (std::size_t c = 0; c < count; ++c) {
      const std::size_t k = first + c;
      const std::size_t cell = strains.cell[k];
      const double mean = domain.grid.cell_dilation[cell] / domain.grid.cell_volume[cell];
      const double half_excess = 0.5 * (mean - (strains.exx[k] + strains.eyy[k]));
      moved.exx[c] = strains.exx[k];
      moved.eyy[c] = strains.eyy[k];
      seen.exx[c] = strains.exx[k] + half_excess;
      seen.eyy[c] = strains.eyy[k] + half_excess;
      moved.gxy[c] = seen.gxy[c] = strains.gxy[k];
      seen.wxy[c] = strains.wxy[k];
      seen.plastic[c] = 0.0;
    }
    strain_chunk(p, first, count, seen, moved, dt, sums);
  }
  return sums.collected();
}

} // namespace

WaitingRange::WaitingRange(WaitingStrains& strains, const TileMap& tiles, std::size_t tile, double* window)
    : strains_(strains), lattice_(&tiles.lattice(tiles.level_of(tile))), place_(tiles.window(tile)),
      window_(window) {}

WaitingRange::WaitingRange(WaitingStrains& strains, const GradedMesh& mesh)
    : strains_(strains), mesh_(&mesh) {}

void WaitingRange::find_cells(const Particles& p, std::size_t first, std::size_t count) {
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t k = first + c;
    if (mesh_ != nullptr) {
      strains_.cell[k] = leaf_at(*mesh_, p.x[k], p.y[k]);
      continue;
    }
    const int column = static_cast<int>(std::floor((p.x[k] - lattice_->x0) / lattice_->h));
    const int row = static_cast<int>(std::floor((p.y[k] - lattice_->y0) / lattice_->h));
    strains_.cell[k] = lattice_->index(column, row);
    in_window_[c] = static_cast<std::size_t>((row - place_.row) * window_columns + column - place_.column);
  }
}

void WaitingRange::hold(const Particles& p, std::size_t first, std::size_t count,
                        const Increments& increments) {
  const auto copy = [&](const ChunkField& from, std::vector<double>& to) {
    std::copy_n(from.begin(), count, to.begin() + static_cast<std::ptrdiff_t>(first));
  };
  copy(increments.exx, strains_.exx);
  copy(increments.eyy, strains_.eyy);
  copy(increments.gxy, strains_.gxy);
  copy(increments.wxy, strains_.wxy);
  if (window_ == nullptr)
    return;
  double* const volumes = sums_of(Sum::cell_volume, window_);
  double* const dilations = sums_of(Sum::cell_dilation, window_);
  for (std::size_t c = 0; c < count; ++c) {
    const double volume = p.volume[first + c];
    volumes[in_window_[c]] += volume;
    dilations[in_window_[c]] += volume * (increments.exx[c] + increments.eyy[c]);
  }
}

bool some_wait(const Domain& domain) {
  return std::ranges::any_of(domain.sets, [](const Particles& p) { return p.traits.cell_dilatation; });
}

void clear_cells(Domain& domain) {
  // All rows: a cell may begin at a node that is tied to finer ones and carries no soil.
  domain.workers.run(domain.row_count(), [&](std::size_t row) {
    const auto [begin, end] = domain.row(row);
    for_group(domain.grid, NodeGroup::cell,
              [&](NodeField& field) { std::fill(field.data() + begin, field.data() + end, 0.0); });
  });
  for (std::size_t s = 0; s < domain.sets.size(); ++s)
    if (domain.sets[s].traits.cell_dilatation)
      domain.waiting_strains[s].resize(domain.sets[s].size());
}

GatherSums strain_by_cells(Domain& domain, int clock, double dt) {
  const ClockTiles& tiles = domain.clock_tiles[static_cast<std::size_t>(clock)];
  add_across(domain, tiles);
  fold(domain, NodeGroup::cell, domain.image_rows); // the images of a period are cells of it
  prolong(domain, NodeGroup::cell, domain.image_rows);
  const std::span<const std::size_t> filled = tiles.sums.filled();
  std::vector<GatherSums> sums(filled.size() + tiles.across.size());
  domain.workers.run(sums.size(), [&](std::size_t task) {
    if (task >= filled.size()) {
      const AcrossTile& tile = tiles.across[task - filled.size()];
      if (domain.sets[tile.set].traits.cell_dilatation)
        sums[task] = strain_range(domain, tile.set, {tile.weights.first(), tile.weights.end()}, dt);
      return;
    }
    for (std::size_t s = 0; s < domain.sets.size(); ++s)
      if (domain.sets[s].traits.cell_dilatation)
        sums[task] += strain_range(domain, s, domain.sets[s].in_block(domain.block(clock, filled[task])), dt);
  });
  GatherSums total;
  for (const GatherSums& sum : sums)
    total += sum;
  return total;
}

} // namespace tremolo::mpm_domain
