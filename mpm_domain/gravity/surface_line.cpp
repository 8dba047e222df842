#include "mpm_domain/gravity/surface_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::mpm_domain {

void SurfaceLine::add(Vector position, double size) {
  const double top = position.y + 0.5 * size;
  const auto [column, is_new] = tops_.try_emplace(std::lround(std::floor(position.x / width_)), top);
  column->second = std::max(column->second, top);
}

double SurfaceLine::at(double x) const {
  constexpr double nearly = 1e-6; // of a column, by which a point on the line between two is in both
  const auto top = [&](double shift) {
    const auto column = tops_.find(std::lround(std::floor(x / width_ + shift)));
    return column == tops_.end() ? -std::numeric_limits<double>::infinity() : column->second;
  };
  return std::min(top(-nearly), top(nearly));
}

} // namespace tremolo::mpm_domain
