#include "mpm_domain/head/phreatic_line.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// No water stands higher than where it comes from, m.
double highest(const GroundWater& water) {
  if (water.seepage)
    return std::max(water.seepage->left, water.seepage->right);
  return water.line.empty() ? std::max(water.level, water.still_wet.value_or(water.level))
                            : std::ranges::max(water.line, {}, &Vector::y).y;
}

} // namespace

std::vector<double> phreatic_line(const Spec& spec, const Head& head) {
  const auto& [x_min, y_min, x_max, y_max] = spec.box;
  const double top = highest(*spec.water);
  const auto cells = static_cast<std::size_t>(std::lround((x_max - x_min) / spec.cell_size));
  std::vector<double> line;
  for (std::size_t i = 0; i <= cells; ++i) {
    const double x = std::lerp(x_min, x_max, static_cast<double>(i) / static_cast<double>(cells));
    line.push_back(x);
    line.push_back(head.surface(x, y_min, top));
  }
  return line;
}

} // namespace tremolo::mpm_domain
