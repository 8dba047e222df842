#include "mpm_domain/grid/graded_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace tremolo::mpm_domain {

namespace {

using mesh::Cell;
using mesh::Roots;

/// The column of cells or nodes of a level that a column represents: itself, or its original within the
/// period.
int real_column(const Roots& roots, int level, int i) {
  if (roots.period == 0)
    return i;
  const int first = roots.first_column << level;
  const int period = roots.period << level;
  const int beyond = (i - first) % period;
  return first + (beyond < 0 ? beyond + period : beyond);
}

/// The real nodes, by their place.
class RealNodes {
public:
  explicit RealNodes(const GradedMesh& mesh) : mesh_(mesh) {
    // Level by level, so that a node that stands in several lattices is that of the finest leaf.
    for (const Cell& leaf : mesh.tree().leaves())
      for (int corner = 0; corner < 4; ++corner) {
        const Cell at{leaf.level, real_column(roots(), leaf.level, leaf.i + corner % 2), leaf.j + corner / 2};
        nodes_[key(at)] = mesh.node(at.level, at.i, at.j);
      }
  }

  /// The real node at a node (level, i, j) of a lattice, if there is one.
  const std::size_t* find(const Cell& at) const {
    const auto found = nodes_.find(key({at.level, real_column(roots(), at.level, at.i), at.j}));
    return found == nodes_.end() ? nullptr : &found->second;
  }

private:
  const Roots& roots() const { return mesh_.tree().roots(); }
  std::uint64_t key(const Cell& at) const {
    const int up = mesh_.tree().finest() - at.level;
    return (static_cast<std::uint64_t>(at.j << up) << 32) | static_cast<std::uint64_t>(at.i << up);
  }

  const GradedMesh& mesh_;
  std::unordered_map<std::uint64_t, std::size_t> nodes_;
};

using Shares = std::vector<Share>;

Shares mean(std::span<const Shares> all) {
  Shares shares;
  for (const Shares& one : all)
    for (const Share& share : one)
      shares.push_back({share.node, share.weight / static_cast<double>(all.size())});
  return shares;
}

/// The nine nodes of a split leaf, row by row, in terms of real ones.
std::array<Shares, 9> split_table(const RealNodes& real, const Cell& leaf) {
  std::array<Shares, 9> table;
  for (const std::size_t corner : {0U, 2U, 6U, 8U}) {
    const int n = static_cast<int>(corner);
    table[corner] = {{*real.find({leaf.level, leaf.i + n % 3 / 2, leaf.j + n / 6}), 1.0}};
  }
  // Mid-edges and the ends of their edges: below, left, right, above.
  constexpr std::array<std::array<std::size_t, 3>, 4> edges{{{1, 0, 2}, {3, 0, 6}, {5, 2, 8}, {7, 6, 8}}};
  std::array<bool, 4> hanging{};
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [mid, a, b] = edges[e];
    const int n = static_cast<int>(mid);
    const std::size_t* const node = real.find({leaf.level + 1, 2 * leaf.i + n % 3, 2 * leaf.j + n / 3});
    hanging[e] = node != nullptr;
    table[mid] = node ? Shares{{*node, 1.0}} : mean(std::array{table[a], table[b]});
  }
  const bool along_x = hanging[1] || hanging[2];
  const bool along_y = hanging[0] || hanging[3];
  if (along_x && along_y)
    table[4] = mean(std::array{table[1], table[3], table[5], table[7]});
  else
    table[4] = along_x ? mean(std::array{table[3], table[5]}) : mean(std::array{table[1], table[7]});
  return table;
}

/// Ties every node of the lattices that is used by a cell and is no real node itself.
class Ties {
public:
  Ties(const GradedMesh& mesh, Prolongation& prolongation)
      : mesh_(mesh), real_(mesh), prolongation_(prolongation), done_(mesh.node_count(), false) {}

  void tie_all() {
    for (const Cell& leaf : mesh_.tree().leaves())
      if (is_split(mesh_.tree(), leaf)) {
        const std::array<Shares, 9> table = split_table(real_, leaf);
        for (int n = 0; n < 9; ++n)
          tie({leaf.level + 1, 2 * leaf.i + n % 3, 2 * leaf.j + n / 3}, table[static_cast<std::size_t>(n)]);
      } else {
        for (int n = 0; n < 4; ++n) {
          const Cell at{leaf.level, leaf.i + n % 2, leaf.j + n / 2};
          tie(at, {{*real_.find(at), 1.0}});
        }
      }
  }

private:
  void tie(const Cell& at, Shares to) {
    const std::size_t node = mesh_.node(at.level, at.i, at.j);
    if (done_[node] || (to.size() == 1 && to.front().node == node))
      return;
    done_[node] = true;
    for (Share& share : to)
      place(share, at);
    prolongation_.tie(node, to);
  }

  void place(Share& share, const Cell& tied) const {
    const Roots& roots = mesh_.tree().roots();
    const auto lattice = std::ranges::find_if(
        mesh_.lattices(), [&](const Lattice& one) { return share.node < one.first + one.count(); });
    const auto n = static_cast<int>(share.node - lattice->first);
    const double h = mesh_.tree().size(tied.level);
    const double period = roots.period * roots.h;
    const int column = n % lattice->nx;
    const int row = n / lattice->nx;
    share.dx = lattice->x0 + column * lattice->h - (roots.x0 + tied.i * h);
    share.dy = lattice->y0 + row * lattice->h - (roots.y0 + tied.j * h);
    if (roots.period > 0)
      share.dx -= period * std::round(share.dx / period);
  }

  const GradedMesh& mesh_;
  RealNodes real_;
  Prolongation& prolongation_;
  std::vector<bool> done_;
};

} // namespace

GradedMesh::GradedMesh(const mesh::Roots& roots, std::span<const mesh::Refinement> refinements)
    : tree_(roots, refinements) {
  for (const LevelLattice& one : lattices_of(tree_)) {
    lattices_.push_back(one.lattice);
    origin_i_.push_back(one.origin_i);
    origin_j_.push_back(one.origin_j);
    node_count_ += one.lattice.count();
  }
  Ties(*this, prolongation_).tie_all();
}

std::optional<mesh::Cell> GradedMesh::part_at(double x, double y) const {
  const mesh::Roots& roots = tree_.roots();
  mesh::Cell cell{0, static_cast<int>(std::floor((x - roots.x0) / roots.h)),
                  static_cast<int>(std::floor((y - roots.y0) / roots.h))};
  const mesh::Rectangle root = tree_.rectangle(cell); // its edges, rounded, decide
  cell.i += (x >= root.x_max ? 1 : 0) - (x < root.x_min ? 1 : 0);
  cell.j += (y >= root.y_max ? 1 : 0) - (y < root.y_min ? 1 : 0);
  if (!tree_.exists(cell))
    return std::nullopt;
  while (tree_.exists(cell) && (tree_.is_cut(cell) || is_split(tree_, cell))) {
    const mesh::Cell last{cell.level + 1, 2 * cell.i + 1, 2 * cell.j + 1};
    const mesh::Rectangle quarter = tree_.rectangle(last);
    cell = {last.level, x < quarter.x_min ? last.i - 1 : last.i, y < quarter.y_min ? last.j - 1 : last.j};
  }
  return cell;
}

} // namespace tremolo::mpm_domain
