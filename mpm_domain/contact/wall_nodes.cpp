#include "mpm_domain/contact/wall_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// Fractions of the way from a to b, in cells, at which a coordinate crosses lines of the lattice.
void add_crossings(double a, double b, std::vector<double>& shares) {
  const auto first = static_cast<int>(std::floor(std::min(a, b))) + 1;
  for (int line = first; line < std::max(a, b); ++line)
    shares.push_back((line - a) / (b - a));
}

} // namespace

NodeWindow nodes_around(const Lattice& lattice, const mesh::Rectangle& box) {
  constexpr int margin = 2;
  const auto first = [&](double position, double origin) {
    return static_cast<int>(std::floor((position - origin) / lattice.h)) - margin;
  };
  const auto last = [&](double position, double origin) {
    return static_cast<int>(std::ceil((position - origin) / lattice.h)) + margin;
  };
  const int i0 = std::max(0, first(box.x_min, lattice.x0));
  const int j0 = std::max(0, first(box.y_min, lattice.y0));
  const int i1 = std::min(lattice.nx - 1, last(box.x_max, lattice.x0));
  const int j1 = std::min(lattice.ny - 1, last(box.y_max, lattice.y0));
  return {i0, j0, std::max(0, i1 - i0 + 1), std::max(0, j1 - j0 + 1)};
}

void find_wall(const BodySurface& surface, const Lattice& lattice, const NodeWindow& window,
               std::vector<double>& lengths) {
  lengths.assign(window.count(), 0.0);
  const std::vector<Vector>& outline = surface.points();
  std::vector<double> cuts;
  for (std::size_t k = 0, before = outline.size() - 1; k < outline.size(); before = k++) {
    // Positions are in cells from node (0, 0).
    const Vector a = (outline[before] - Vector{lattice.x0, lattice.y0}) / lattice.h;
    const Vector b = (outline[k] - Vector{lattice.x0, lattice.y0}) / lattice.h;
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length == 0.0)
      continue;
    cuts.assign({0.0, 1.0});
    add_crossings(a.x, b.x, cuts);
    add_crossings(a.y, b.y, cuts);
    std::ranges::sort(cuts);
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
      const auto on_edge = [&](double t) { return a + t * (b - a); };
      const Vector from = on_edge(cuts[c]);
      const Vector middle = on_edge(0.5 * (cuts[c] + cuts[c + 1]));
      const Vector to = on_edge(cuts[c + 1]);
      const int i = static_cast<int>(std::floor(middle.x));
      const int j = static_cast<int>(std::floor(middle.y));
      const double piece = (cuts[c + 1] - cuts[c]) * length * lattice.h;
      for (int dj = 0; dj < 2; ++dj)
        for (int di = 0; di < 2; ++di) {
          if (!window.has(i + di, j + dj))
            continue;
          const auto hat = [&](const Vector& p) {
            return std::max(0.0, 1.0 - std::abs(p.x - (i + di))) *
                   std::max(0.0, 1.0 - std::abs(p.y - (j + dj)));
          };
          lengths[window.index(i + di, j + dj)] += piece * (hat(from) + 4.0 * hat(middle) + hat(to)) / 6.0;
        }
    }
  }
}

} // namespace tremolo::mpm_domain
