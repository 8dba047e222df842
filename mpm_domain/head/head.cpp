#include "mpm_domain/head/head.hpp"

#include "mpm_domain/spec/on_line.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// A point along an axis of nodes: the node before it, and how far it lies on the way to the next.
struct Along {
  std::size_t before;
  double way;  ///< 0 to 1
  bool beyond; ///< the first or the last node
};
Along along(double position, double first, double h, std::size_t nodes) {
  const double cells = static_cast<double>(nodes - 1);
  const double at = (position - first) / h;
  const double inside = std::clamp(at, 0.0, cells);
  const double before = std::min(std::floor(inside), cells - 1.0);
  return {static_cast<std::size_t>(before), inside - before, at != inside};
}

HeadThere between(const HeadGrid& grid, double x, double y) {
  const Along i = along(x, grid.x0, grid.h, grid.columns);
  const Along j = along(y, grid.y0, grid.h, grid.rows);
  const double* low = &grid.heads[grid.node(i.before, j.before)];
  const double* high = low + grid.columns;
  const double below = low[0] + i.way * (low[1] - low[0]);
  const double above = high[0] + i.way * (high[1] - high[0]);
  const double across = (1.0 - j.way) * (low[1] - low[0]) + j.way * (high[1] - high[0]);
  return {below + j.way * (above - below),
          {i.beyond ? 0.0 : across / grid.h, j.beyond ? 0.0 : (above - below) / grid.h}};
}

} // namespace

HeadThere Head::at(double x, double y) const {
  if (const auto* level = std::get_if<double>(&field_))
    return {*level, {}};
  if (const auto* line = std::get_if<std::vector<Vector>>(&field_)) {
    const auto [head, slope] = on_line(*line, x);
    return {head, {slope, 0.0}};
  }
  return between(std::get<HeadGrid>(field_), x, y);
}

double Head::surface(double x, double low, double high) const {
  const auto* grid = std::get_if<HeadGrid>(&field_);
  if (grid == nullptr)
    return std::clamp(at(x, low).head, low, high);
  const auto pressure_head = [&](double y) { return at(x, y).head - y; };
  double above = high;
  if (pressure_head(high) > 0.0)
    return high;
  while (above > low) {
    const double y = std::max(above - grid->h, low);
    if (const double psi = pressure_head(y); psi > 0.0)
      return y + (above - y) * psi / (psi - pressure_head(above));
    above = y;
  }
  return low;
}

} // namespace tremolo::mpm_domain
