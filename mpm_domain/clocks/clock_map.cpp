#include "mpm_domain/clocks/clock_map.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

int clock_of(const mesh::Quadtree& tree, const mesh::Cell& leaf, int buffer_layers) {
  for (int clock = tree.finest(); clock > leaf.level; --clock) {
    const double reach = buffer_layers * tree.size(clock - 1);
    const mesh::Rectangle all = tree.rectangle(leaf);
    if (tree.finest_in({all.x_min - reach, all.y_min - reach, all.x_max + reach, all.y_max + reach}) >= clock)
      return clock;
  }
  return leaf.level;
}

} // namespace

ClockMap::ClockMap(const mesh::Quadtree& tree, int buffer_layers)
    : count_(tree.finest() + 1), x0_(tree.roots().x0), y0_(tree.roots().y0),
      per_h_(1.0 / tree.size(tree.finest())), nx_(tree.roots().nx << tree.finest()),
      ny_(tree.roots().ny << tree.finest()),
      clock_(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_)) {
  for (const mesh::Cell& leaf : tree.leaves()) {
    const auto clock = static_cast<std::uint8_t>(clock_of(tree, leaf, buffer_layers));
    const int cells = 1 << (tree.finest() - leaf.level);
    for (int j = leaf.j * cells; j < (leaf.j + 1) * cells; ++j)
      std::fill_n(clock_.begin() + static_cast<std::ptrdiff_t>(j) * nx_ +
                      static_cast<std::ptrdiff_t>(leaf.i) * cells,
                  cells, clock);
  }
}

int ClockMap::at(double x, double y) const {
  if (count_ == 1)
    return 0;
  const int i = std::clamp(static_cast<int>(std::floor((x - x0_) * per_h_)), 0, nx_ - 1);
  const int j = std::clamp(static_cast<int>(std::floor((y - y0_) * per_h_)), 0, ny_ - 1);
  return clock_[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(i)];
}

} // namespace tremolo::mpm_domain
