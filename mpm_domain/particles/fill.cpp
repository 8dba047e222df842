#include "mpm_domain/particles/fill.hpp"

#include "mesh/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

int count_along(double length, double size) {
  const double n = length / size;
  if (std::abs(n - std::round(n)) > 1e-6 || n < 1.0)
    throw std::invalid_argument(
        fmt::format("the model box is {:.6g} m long, which is not a multiple of the particle size {:.6g} m",
                    length, size));
  return static_cast<int>(std::lround(n));
}

/// The part of a particle's square that is soil.
struct Plot {
  double x, y; ///< of its centroid, m
  double area; ///< m2
};

/// Squares with less soil than this share carry no particle.
constexpr double least_plot = 0.01;

/// Whether an edge of a polygon runs through a square.
template <typename Polygon>
bool cuts(const Polygon& polygon, const mesh::Rectangle& square) {
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    double first = 0.0; // of the part of the edge within, as shares of it
    double last = 1.0;
    const auto clip = [&](double from, double to, double low, double high) {
      const double way = to - from;
      if (way == 0.0) {
        if (from <= low || from >= high)
          last = -1.0;
        return;
      }
      const double a = (low - from) / way;
      const double b = (high - from) / way;
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b));
    };
    clip(polygon[j].x, polygon[i].x, square.x_min, square.x_max);
    clip(polygon[j].y, polygon[i].y, square.y_min, square.y_max);
    if (first < last)
      return true;
  }
  return false;
}

/// What of a square lies in regions and in no structure. Without structures it is all of the square or
/// nothing, by its centre: the surface of the soil is then a staircase of squares, which waves do not mind,
/// but bodies do. Squares that edges run through are sampled.
Plot plot_of(const Spec& spec, double x, double y, double size) {
  const auto is_soil = [&](double px, double py) {
    return std::ranges::any_of(spec.regions,
                               [&](const Region& r) { return mesh::inside(r.polygon, px, py); }) &&
           std::ranges::none_of(spec.structures,
                                [&](const Structure& s) { return mesh::inside(s.outline, px, py); });
  };
  const mesh::Rectangle square{x - 0.5 * size, y - 0.5 * size, x + 0.5 * size, y + 0.5 * size};
  const bool cut =
      !spec.structures.empty() &&
      (std::ranges::any_of(spec.regions, [&](const Region& r) { return cuts(r.polygon, square); }) ||
       std::ranges::any_of(spec.structures, [&](const Structure& s) { return cuts(s.outline, square); }));
  if (!cut)
    return {x, y, is_soil(x, y) ? size * size : 0.0};
  constexpr int samples = 32; // a direction
  Plot plot{0.0, 0.0, 0.0};
  int hits = 0;
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const double px = square.x_min + (i + 0.5) * size / samples;
      const double py = square.y_min + (j + 0.5) * size / samples;
      if (is_soil(px, py)) {
        plot.x += px;
        plot.y += py;
        ++hits;
      }
    }
  if (hits == samples * samples)
    return {x, y, size * size};
  if (hits < least_plot * samples * samples)
    return {x, y, 0.0};
  return {plot.x / hits, plot.y / hits, size * size * hits / (samples * samples)};
}

void add_particle(Particles& set, std::uint32_t id, const Plot& plot) {
  set.id.push_back(id);
  set.for_fields([](const ParticleFieldDescription&, std::vector<double>& values) { values.push_back(0.0); });
  const auto [x, y, area] = plot;
  set.x.back() = set.x_initial.back() = x;
  set.y.back() = set.y_initial.back() = y;
  set.volume.back() = area;
  set.mass.back() = set.density * area;
  if (set.traits.own_boxes)
    set.box_xx.back() = set.box_yy.back() = set.half_size * set.half_size;
  if (set.traits.wet)
    set.pore_pressure.back() = set.pressure_at_rest.back() = set.water->hydrostatic(y);
}

/// What soil of a region becomes: particles above the water table, or below it.
struct Kind {
  std::size_t soil;
  bool under_water;
};

/// Soil with pores may lie on both sides of the table.
std::vector<Kind> kinds_of(const Spec& spec) {
  std::vector<Kind> kinds;
  for (std::size_t s = 0; s < spec.soils.size(); ++s)
    kinds.push_back({s, false});
  for (std::size_t s = 0; s < spec.soils.size(); ++s)
    if (spec.water && spec.soils[s].pores)
      kinds.push_back({s, true});
  return kinds;
}

/// Gives a set that lies below the table its water, and the densities that go with its drainage.
void fill_pores(Particles& set, const materials::PoreSpace& pores, const Spec& spec) {
  const materials::PoreFluid& fluid = spec.water->fluid;
  const double dry = materials::dry_density(pores);
  const double saturated = materials::saturated_density(pores, fluid);
  const bool flows = pores.drainage == materials::Drainage::coupled;
  set.traits.wet = pores.drainage != materials::Drainage::drained;
  set.traits.flowing = flows;
  set.density = flows ? dry : saturated;
  set.weight_share = materials::buoyant_density(pores, fluid) / set.density;
  set.water = {.pores = pores,
               .fluid = fluid,
               .level = spec.water->level,
               .unit_weight = fluid.density * spec.gravity,
               .grains_per_mass = (1.0 - pores.porosity) / set.density};
}

std::vector<Particles> empty_sets(const Spec& spec, int finest) {
  std::vector<Particles> sets;
  for (int level = 0; level <= finest; ++level)
    for (const auto& [s, under_water] : kinds_of(spec)) {
      const Soil& soil = spec.soils[s];
      const auto finer = static_cast<std::size_t>(level) - 1;
      Particles& set = sets.emplace_back();
      set.soil = soil.name;
      set.soil_index = s;
      set.traits = {.affine = spec.scheme.transfer == Transfer::apic,
                    .own_boxes = spec.boxes == ParticleBoxes::deforming,
                    .cell_dilatation = spec.scheme.dilatation == Dilatation::cell &&
                                       materials::traits(soil.law).response != materials::Response::elastic,
                    .damped = soil.damping_time > 0.0};
      set.damping_time = soil.damping_time;
      set.more_fields = spec.more_fields;
      set.more.resize(spec.more_fields.size());
      set.level = level;
      set.cell_size = spec.cell_size / static_cast<double>(1 << level);
      set.half_size = 0.5 * particle_size(spec, level);
      set.law = level > 0 && finer < soil.finer_laws.size() ? soil.finer_laws[finer] : soil.law;
      set.state_size = materials::state_variables(set.law).size();
      set.density = spec.water && soil.pores ? materials::dry_density(*soil.pores)
                                             : materials::elasticity(set.law).density;
      if (under_water)
        fill_pores(set, *soil.pores, spec);
    }
  return sets;
}

/// The lattice points of a leaf that lie in the model.
template <typename Add>
void fill_leaf(const Spec& spec, int level, const Box& leaf, const Add& add) {
  const double size = particle_size(spec, level);
  for (int j = 0; j < spec.particles_per_cell; ++j)
    for (int i = 0; i < spec.particles_per_cell; ++i) {
      const double x = leaf.x_min + (i + 0.5) * size;
      const double y = leaf.y_min + (j + 0.5) * size;
      if (x > spec.box.x_min && x < spec.box.x_max && y > spec.box.y_min && y < spec.box.y_max)
        add(level, x, y);
    }
}

} // namespace

std::vector<Particles> fill(const Spec& spec, const mesh::Quadtree* tree) {
  const double size = particle_size(spec);
  const int columns = count_along(spec.box.x_max - spec.box.x_min, size);
  const int rows = count_along(spec.box.y_max - spec.box.y_min, size);

  std::vector<Particles> sets = empty_sets(spec, tree ? tree->finest() : 0);
  const std::vector<Kind> kinds = kinds_of(spec);
  const auto add = [&](int level, double x, double y) {
    const Plot plot = plot_of(spec, x, y, particle_size(spec, level));
    if (plot.area == 0.0)
      return;
    const auto region = std::find_if(spec.regions.rbegin(), spec.regions.rend(), [&](const Region& r) {
      return mesh::inside(r.polygon, x, y) || (plot.x != x && mesh::inside(r.polygon, plot.x, plot.y));
    });
    if (region == spec.regions.rend())
      return;
    const bool under_water = spec.water && spec.soils[region->soil].pores && y < spec.water->level;
    const auto kind = std::ranges::find_if(kinds, [&](const Kind& candidate) {
      return candidate.soil == region->soil && candidate.under_water == under_water;
    });
    Particles& set =
        sets[static_cast<std::size_t>(level) * kinds.size() + static_cast<std::size_t>(kind - kinds.begin())];
    add_particle(set, static_cast<std::uint32_t>(set.size()), plot);
  };
  if (tree)
    for (const mesh::Cell& leaf : tree->leaves())
      fill_leaf(spec, leaf.level, tree->rectangle(leaf), add);
  else
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        add(0, spec.box.x_min + (i + 0.5) * size, spec.box.y_min + (j + 0.5) * size);
  if (std::all_of(sets.begin(), sets.end(), [](const Particles& set) { return set.size() == 0; }))
    throw std::invalid_argument("no particle lies in any region: the domain is empty");
  for (Particles& set : sets) {
    set.state.resize(set.size() * set.state_size);
    materials::initialise(set.law, set.points(0, set.size()));
  }
  return sets;
}

/// Every particle stands in all columns, as wide as the smallest particles, that it covers, and takes the
/// mean of their overburdens.
void set_rest_stress(std::vector<Particles>& sets, const Spec& spec) {
  const int finest = std::ranges::max(sets, {}, &Particles::level).level;
  const double width = particle_size(spec, finest);
  struct Place {
    double y;
    Particles* set;
    std::size_t k;
  };
  std::vector<std::vector<Place>> columns(
      static_cast<std::size_t>(std::lround((spec.box.x_max - spec.box.x_min) / width)));
  for (Particles& set : sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      const auto first =
          static_cast<std::size_t>((set.x[k] - set.half_size + 0.5 * width - spec.box.x_min) / width);
      for (std::size_t c = 0; c < std::size_t{1} << (finest - set.level); ++c)
        columns[first + c].push_back({set.y[k], &set, k});
      set.syy[k] = 0.0;
    }
  for (std::vector<Place>& column : columns) {
    std::sort(column.begin(), column.end(), [](const Place& a, const Place& b) { return a.y > b.y; });
    double overburden = 0.0;
    for (const Place& place : column) {
      Particles& set = *place.set;
      const double weight = set.weight_share * set.mass[place.k] * spec.gravity / (2.0 * set.half_size);
      set.syy[place.k] -= (overburden + 0.5 * weight) / static_cast<double>(1 << (finest - set.level));
      overburden += weight;
    }
  }
  for (Particles& set : sets) {
    const double k0 = materials::elasticity(set.law).rest_coefficient();
    for (std::size_t k = 0; k < set.size(); ++k)
      set.sxx[k] = set.szz[k] = k0 * set.syy[k];
  }
}

} // namespace tremolo::mpm_domain
