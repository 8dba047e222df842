#include "mpm_domain/particles/fill/fill.hpp"

#include "mesh/cell_size.hpp"
#include "mesh/polygon.hpp"
#include "mpm_domain/particles/fill/plots.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/spec/plot.hpp"
#include "mpm_domain/spec/slices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

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

/// Kind of particles that a region's soil becomes: above the water table, or below it.
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
                    .bilinear = spec.scheme.dispersion == Dispersion::reduced,
                    .own_boxes = spec.boxes == ParticleBoxes::deforming,
                    .cell_dilatation = spec.scheme.dilatation == Dilatation::cell &&
                                       materials::traits(soil.law).response != materials::Response::elastic,
                    .damped = soil.damping_time > 0.0 || soil.relaxation.acts()};
      set.damping_time = soil.damping_time;
      set.relaxation = soil.relaxation;
      set.more_fields = spec.more_fields;
      set.first_memory = set.more_fields.size();
      std::ranges::copy(relaxation_fields(soil.relaxation.time.size()), std::back_inserter(set.more_fields));
      set.more.resize(set.more_fields.size());
      set.level = level;
      set.cell_size = mesh::cell_size(spec.cell_size, level);
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

template <typename Owner>
std::vector<std::vector<Vector>> polygons_of(const std::vector<Owner>& owners,
                                             std::vector<Vector> Owner::*polygon) {
  std::vector<std::vector<Vector>> polygons;
  std::ranges::transform(owners, std::back_inserter(polygons), polygon);
  return polygons;
}

/// The part of a sequence that a process lays; those of ranks 0, 1, ... follow each other.
std::pair<std::size_t, std::size_t> part_of(const Communicator* ranks, std::size_t length) {
  if (ranks == nullptr)
    return {0, length};
  const auto rank = static_cast<std::size_t>(ranks->rank());
  const auto count = static_cast<std::size_t>(ranks->size());
  return {length * rank / count, length * (rank + 1) / count};
}

} // namespace

std::vector<Particles> fill(const Spec& spec, const std::optional<Head>& head, const mesh::Quadtree* tree,
                            Communicator* ranks) {
  const double size = particle_size(spec);
  const int columns = count_along(spec.box.x_max - spec.box.x_min, size);
  const int rows = count_along(spec.box.y_max - spec.box.y_min, size);

  std::vector<Particles> sets = empty_sets(spec, tree ? tree->finest() : 0);
  const std::vector<Kind> kinds = kinds_of(spec);
  const auto regions = polygons_of(spec.regions, &Region::polygon);
  auto structures = polygons_of(spec.structures, &Structure::outline);
  std::ranges::transform(spec.linings, std::back_inserter(structures), &Lining::outline);
  if (structures.empty() && spec.cut_at_edges)
    structures.emplace_back(); // an outline without corners
  Plots plots(sets, ranks);
  const auto add = [&](int level, double x, double y) {
    const Plot plot = plot_of(regions, structures, x, y, particle_size(spec, level));
    if (plot.area == 0.0)
      return;
    const auto region = std::find_if(spec.regions.rbegin(), spec.regions.rend(), [&](const Region& r) {
      return mesh::inside(r.polygon, x, y) || (plot.x != x && mesh::inside(r.polygon, plot.x, plot.y));
    });
    if (region == spec.regions.rend())
      return;
    const std::size_t soil = soil_at(region->soil, region->cuts, y);
    const bool under_water = head && spec.soils[soil].pores && head->is_wet(x, y);
    const auto kind = std::ranges::find_if(kinds, [&](const Kind& candidate) {
      return candidate.soil == soil && candidate.under_water == under_water;
    });
    plots.add(static_cast<std::size_t>(level) * kinds.size() + static_cast<std::size_t>(kind - kinds.begin()),
              plot, particle_size(spec, level));
  };
  const std::vector<mesh::Cell> leaves = tree ? tree->leaves() : std::vector<mesh::Cell>{};
  const std::size_t length = tree ? leaves.size() : static_cast<std::size_t>(rows);
  for (auto [n, end] = part_of(ranks, length); n < end; ++n)
    if (tree)
      fill_leaf(spec, leaves[n].level, tree->rectangle(leaves[n]), add);
    else
      for (int i = 0; i < columns; ++i)
        add(0, spec.box.x_min + (i + 0.5) * size, spec.box.y_min + (static_cast<double>(n) + 0.5) * size);
  plots.join_slivers();
  if (ranks == nullptr && std::ranges::all_of(sets, [](const Particles& set) { return set.size() == 0; }))
    throw std::invalid_argument(no_particle);
  for (Particles& set : sets) {
    set.state.resize(set.size() * set.state_size);
    materials::initialise(set.law, set.points(0, set.size()));
  }
  return sets;
}

} // namespace tremolo::mpm_domain
