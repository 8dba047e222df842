#include "mpm_domain/particles/fill/plots.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

void add_particle(Particles& set, const Plot& plot) {
  set.id.push_back(static_cast<std::uint32_t>(set.id.size()));
  set.for_fields([](const ParticleFieldDescription&, std::vector<double>& values) { values.push_back(0.0); });
  const auto [x, y, area] = plot;
  set.x.back() = set.x_initial.back() = x;
  set.y.back() = set.y_initial.back() = y;
  set.volume.back() = area;
  set.mass.back() = set.density * area;
  if (set.traits.own_boxes)
    set.box_xx.back() = set.box_yy.back() = set.half_size * set.half_size;
}

std::size_t nearest(const Particles& set, const Plot& plot) {
  std::size_t found = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < set.size(); ++k)
    if (const double distance = std::hypot(set.x[k] - plot.x, set.y[k] - plot.y); distance < least) {
      least = distance;
      found = k;
    }
  return found;
}

} // namespace

void Plots::add(Particles& set, const Plot& plot, double size) {
  if (is_particle(plot, size))
    add_particle(set, plot);
  else if (plot.area > 0.0)
    slivers_.emplace_back(&set, plot);
}

void Plots::join_slivers() {
  for (const auto& [set, plot] : slivers_) {
    if (set->size() == 0) {
      add_particle(*set, plot);
      continue;
    }
    const std::size_t k = nearest(*set, plot);
    set->volume[k] += plot.area;
    set->mass[k] += set->density * plot.area;
  }
  slivers_.clear();
}

} // namespace tremolo::mpm_domain
