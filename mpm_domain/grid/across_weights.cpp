#include "mpm_domain/grid/across_weights.hpp"

#include <algorithm>
#include <optional>

namespace tremolo::mpm_domain {

namespace {

/// S and G that a part of a box adds to four nodes of its cell.
FourWeights weights_of(const FourNodes& nodes, std::uint32_t four, std::uint32_t position,
                       const BasisCell& cell, const BoxPart& part) {
  const auto& [below_left, below_right, above_left, above_right] = nodes.corners;
  const auto& [share, xi, eta] = part;
  const double slope = share * cell.per_h;
  return {nodes.node,
          four,
          position,
          share * (1.0 - eta) * ((1.0 - xi) * below_left + xi * below_right) +
              share * eta * ((1.0 - xi) * above_left + xi * above_right),
          slope * ((1.0 - eta) * (below_right - below_left) + eta * (above_right - above_left)),
          slope * ((1.0 - xi) * (above_left - below_left) + xi * (above_right - below_right))};
}

} // namespace

void AcrossWeights::restart(std::size_t first) {
  first_ = first;
  cells_start_.assign(1, 0);
  cells_.clear();
  fours_.clear();
  clear();
}

void AcrossWeights::expect(const GradedMesh& mesh, BasisCells& cells, const mesh::Rectangle& reach) {
  mesh.for_parts(reach, [&](const mesh::Cell& cell, const mesh::Rectangle&) {
    cells_.push_back({cells.number_of(mesh, cell), 0});
  });
  cells_start_.push_back(cells_.size());
}

void AcrossWeights::settle(const BasisCells& cells) {
  std::vector<TouchedCell*> by_key;
  for (TouchedCell& cell : cells_)
    by_key.push_back(&cell);
  const auto key = [&](const TouchedCell* cell) { return cells[cell->number].key; };
  std::ranges::sort(by_key, {}, key);
  std::optional<std::uint64_t> last;
  std::uint32_t first_place = 0;
  for (TouchedCell* cell : by_key) {
    if (last != key(cell)) {
      last = key(cell);
      first_place = static_cast<std::uint32_t>(fours_.size());
      for (std::uint32_t four = cells[cell->number].first; four < cells[cell->number].end; ++four)
        fours_.push_back(four);
    }
    cell->first_place = first_place;
  }
}

void AcrossWeights::clear() {
  start_.assign(1, 0);
  weights_.clear();
  per_moments_.clear();
}

bool AcrossWeights::add(const BasisCells& table, const mesh::Rectangle& box) {
  const std::size_t n = start_.size() - 1;
  const double x = 0.5 * (box.x_min + box.x_max);
  const double y = 0.5 * (box.y_min + box.y_max);
  const double per_area = 1.0 / box.area();
  double covered = 0.0; // share of the box
  Lanes dxx{};
  Lanes dyy{};
  for (std::size_t c = cells_start_[n]; c < cells_start_[n + 1]; ++c) {
    const BasisCell& cell = table[cells_[c].number];
    const std::optional<BoxPart> part = part_in(cell, box, per_area);
    if (!part)
      continue;
    covered += part->share;
    std::uint32_t position = cells_[c].first_place;
    for (std::uint32_t four = cell.first; four < cell.end; ++four, ++position) {
      const FourNodes& nodes = table.four(four);
      const FourWeights& w = weights_.emplace_back(weights_of(nodes, four, position, cell, *part));
      const Lanes dx = nodes.x - x;
      const Lanes dy = nodes.y - y;
      dxx += w.s * dx * dx;
      dyy += w.s * dy * dy;
    }
  }
  start_.push_back(weights_.size());
  per_moments_.push_back({1.0 / sum(dxx), 1.0 / sum(dyy)});
  return covered > 1.0 - 1e-6;
}

} // namespace tremolo::mpm_domain
