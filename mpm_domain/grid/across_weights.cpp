#include "mpm_domain/grid/across_weights.hpp"

namespace tremolo::mpm_domain {

namespace {

/// S and G that a part of a box adds to four nodes of its cell.
FourWeights weights_of(const FourNodes& nodes, std::uint32_t place, const BasisCell& cell,
                       const BoxPart& part) {
  const auto& [below_left, below_right, above_left, above_right] = nodes.corners;
  const auto& [share, xi, eta] = part;
  const double slope = share * cell.per_h;
  return {nodes.node, place,
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
  clear();
}

void AcrossWeights::expect(const GradedMesh& mesh, BasisCells& cells, const mesh::Rectangle& reach) {
  mesh.for_parts(reach, [&](const mesh::Cell& cell, const mesh::Rectangle&) {
    cells_.push_back(cells.number_of(mesh, cell));
  });
  cells_start_.push_back(cells_.size());
}

void AcrossWeights::clear() {
  start_.assign(1, 0);
  weights_.clear();
  per_moments_.clear();
}

void AcrossWeights::add(const BasisCells& table, const mesh::Rectangle& box) {
  const std::size_t n = start_.size() - 1;
  const std::span cells = std::span(cells_).subspan(cells_start_[n], cells_start_[n + 1] - cells_start_[n]);
  const double x = 0.5 * (box.x_min + box.x_max);
  const double y = 0.5 * (box.y_min + box.y_max);
  Lanes dxx{};
  Lanes dyy{};
  for_parts(table, cells, box, [&](const BasisCell& cell, const BoxPart& part) {
    for (std::uint32_t place = cell.first; place < cell.end; ++place) {
      const FourNodes& nodes = table.four(place);
      const FourWeights& w = weights_.emplace_back(weights_of(nodes, place, cell, part));
      const Lanes dx = nodes.x - x;
      const Lanes dy = nodes.y - y;
      dxx += w.s * dx * dx;
      dyy += w.s * dy * dy;
    }
  });
  start_.push_back(weights_.size());
  per_moments_.push_back({1.0 / sum(dxx), 1.0 / sum(dyy)});
}

} // namespace tremolo::mpm_domain
