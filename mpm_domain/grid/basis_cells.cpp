#include "mpm_domain/grid/basis_cells.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// A real node, or an image of one, and its shares in the four corners of a cell.
struct NodeShares {
  std::size_t node;
  double x, y;
  std::array<double, 4> corners;
};

/// The nodes of a cell; images of one node, a period >= h apart, stand for themselves.
class CellNodes {
public:
  explicit CellNodes(double h) : near_(0.5 * h) {}

  void add(std::size_t node, double x, double y, std::size_t corner, double share) {
    const auto same = [&](const NodeShares& one) { return one.node == node && std::abs(one.x - x) < near_; };
    auto at = std::ranges::find_if(nodes_, same);
    if (at == nodes_.end())
      at = nodes_.insert(at, {node, x, y, {}});
    at->corners[corner] += share;
  }
  const std::vector<NodeShares>& all() const { return nodes_; }

private:
  double near_;
  std::vector<NodeShares> nodes_;
};

std::uint64_t key_of(const mesh::Cell& cell) {
  return (static_cast<std::uint64_t>(cell.level) << 56U) | (static_cast<std::uint64_t>(cell.j) << 28U) |
         static_cast<std::uint64_t>(cell.i);
}

} // namespace

std::uint32_t BasisCells::number_of(const GradedMesh& mesh, const mesh::Cell& cell) {
  const auto [at, is_new] = numbers_.try_emplace(key_of(cell), static_cast<std::uint32_t>(cells_.size()));
  if (is_new) {
    const auto first = static_cast<std::uint32_t>(fours_.size());
    add_nodes(mesh, cell);
    cells_.push_back({key_of(cell), mesh.tree().rectangle(cell), 1.0 / mesh.tree().size(cell.level), first,
                      static_cast<std::uint32_t>(fours_.size())});
  }
  return at->second;
}

void BasisCells::add_nodes(const GradedMesh& mesh, const mesh::Cell& cell) {
  const mesh::Rectangle all = mesh.tree().rectangle(cell);
  CellNodes nodes(mesh.tree().roots().h);
  for (const int corner : {0, 1, 2, 3}) {
    const auto c = static_cast<std::size_t>(corner);
    const std::size_t node = mesh.node(cell.level, cell.i + corner % 2, cell.j + corner / 2);
    const double x = corner % 2 == 1 ? all.x_max : all.x_min;
    const double y = corner / 2 == 1 ? all.y_max : all.y_min;
    const std::span<const Share> shares = mesh.prolongation().shares_of(node);
    if (shares.empty())
      nodes.add(node, x, y, c, 1.0);
    for (const Share& share : shares)
      nodes.add(share.node, x + share.dx, y + share.dy, c, share.weight);
  }
  for (std::size_t n = 0; n < nodes.all().size(); ++n) {
    const std::size_t lane = n % 4;
    if (lane == 0)
      fours_.emplace_back();
    FourNodes& four = fours_.back();
    const NodeShares& from = nodes.all()[n];
    four.node[lane] = static_cast<std::uint32_t>(from.node);
    four.x[lane] = from.x;
    four.y[lane] = from.y;
    for (std::size_t corner = 0; corner < 4; ++corner)
      four.corners[corner][lane] = from.corners[corner];
  }
}

} // namespace tremolo::mpm_domain
