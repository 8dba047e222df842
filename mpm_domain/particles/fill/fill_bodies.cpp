#include "mpm_domain/particles/fill/fill_bodies.hpp"

#include "mesh/cell_size.hpp"
#include "mesh/polygon_measures.hpp"
#include "mpm_domain/particles/fill/fill.hpp"
#include "mpm_domain/particles/fill/plots.hpp"
#include "mpm_domain/spec/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

Particles empty_set(const Spec& spec, const Structure& structure, std::size_t body, int level) {
  Particles set;
  set.soil = structure.name;
  set.body = body;
  set.traits = {.affine = spec.scheme.transfer == Transfer::apic,
                .own_boxes = spec.boxes == ParticleBoxes::deforming};
  set.more_fields = spec.more_fields;
  set.more.resize(spec.more_fields.size());
  set.level = level;
  set.cell_size = mesh::cell_size(spec.cell_size, level);
  set.half_size = 0.5 * particle_size(spec, level);
  set.law = materials::LinearElastic{{.density = structure.density,
                                      .young = structure.stiffness->young,
                                      .poisson = structure.stiffness->poisson}};
  set.density = structure.density;
  return set;
}

/// Below the table the body weighs less by the water that it displaces; its stress is that beyond the
/// pressure of water at rest.
Particles under_water(Particles set, const Spec& spec) {
  const materials::PoreFluid& fluid = spec.water->fluid;
  set.weight_share = 1.0 - fluid.density / set.density;
  PoreWater water;
  water.fluid = fluid;
  water.unit_weight = fluid.density * spec.gravity;
  set.water = water;
  return set;
}

/// Squares with too little of the body carry no particle; the others take over the mass of these.
void keep_mass(std::array<Particles, 2>& parts, const Structure& structure) {
  const double area = mesh::measures(structure.outline).area - mesh::measures(structure.hole).area;
  double filled = 0.0;
  for (const Particles& set : parts)
    filled = std::accumulate(set.volume.begin(), set.volume.end(), filled);
  for (Particles& set : parts) {
    set.density *= area / filled;
    for (double& mass : set.mass)
      mass *= area / filled;
  }
}

} // namespace

std::vector<Particles> fill_bodies(const Spec& spec, const std::optional<Head>& head, int finest) {
  const double size = particle_size(spec, finest);
  std::vector<Particles> sets;
  std::size_t body = 0;
  for (const Structure& structure : spec.structures) {
    if (!structure.stiffness)
      continue;
    std::array<Particles, 2> parts; // above the water table and below it
    parts.front() = empty_set(spec, structure, body++, finest);
    materials::validate(parts.front().law);
    if (head)
      parts.back() = under_water(parts.front(), spec);
    Plots plots(parts);
    const std::array outlines{structure.outline};
    const std::array holes{structure.hole};
    const auto [left, right] = std::ranges::minmax(structure.outline, {}, &Vector::x);
    const auto [low, high] = std::ranges::minmax(structure.outline, {}, &Vector::y);
    const auto first = [&](double position, double origin) { return std::floor((position - origin) / size); };
    for (double j = first(low.y, spec.box.y_min); spec.box.y_min + j * size < high.y; ++j)
      for (double i = first(left.x, spec.box.x_min); spec.box.x_min + i * size < right.x; ++i) {
        const double x = spec.box.x_min + (i + 0.5) * size;
        const double y = spec.box.y_min + (j + 0.5) * size;
        const Plot plot = plot_of(outlines, holes, x, y, size);
        plots.add(head && head->is_wet(plot.x, plot.y) ? 1 : 0, plot, size);
      }
    plots.join_slivers();
    if (parts.front().size() + parts.back().size() == 0)
      throw std::invalid_argument(fmt::format("no particle lies in structure '{}'", structure.name));
    keep_mass(parts, structure);
    for (Particles& set : parts)
      if (set.size() > 0)
        sets.push_back(std::move(set));
  }
  return sets;
}

} // namespace tremolo::mpm_domain
