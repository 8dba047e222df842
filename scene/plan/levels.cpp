#include "scene/plan/levels.hpp"

#include "mpm_domain/spec/grid_shape.hpp"
#include "mpm_domain/spec/limits.hpp"
#include "mpm_domain/spec/plot.hpp"
#include "scene/meeting_boxes.hpp"
#include "scene/plan/structures.hpp"
#include "scene/plan/wet_soils.hpp"
#include "scene/soils/domain_soils.hpp"
#include "scene/soils/viscous_damping.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace tremolo::scene {

namespace {

mesh::Rectangle rectangle(const Box& box) {
  return {box.x_min, box.y_min, box.x_max, box.y_max};
}

mpm_domain::GridShape grid_shape_of(const Case& scene) {
  return mpm_domain::grid_shape(rectangle(scene.mesh.box), scene.mesh.size, scene.boundary.sides);
}

/// c_p of a soil, m/s: that of sand in the stress that its own weight would cause at the base of the model.
double p_wave_speed(const Case& scene, const materials::Law& law) {
  const auto& elastic = materials::elasticity(law);
  if (!(elastic.density > 0.0) || !(elastic.young > 0.0))
    return 0.0;
  if (!materials::traits(law).follows_pressure || !scene.gravity)
    return elastic.p_wave_speed();
  double syy = -elastic.density * scene.gravity->acceleration * scene.mesh.box.height();
  double sxx = elastic.rest_coefficient() * syy;
  double szz = sxx;
  double sxy = 0.0;
  std::vector<double> state(materials::state_variables(law).size());
  materials::Points point;
  point.count = 1;
  point.sxx = &sxx;
  point.syy = &syy;
  point.szz = &szz;
  point.sxy = &sxy;
  point.state = state.data();
  materials::initialise(law, point);
  return materials::p_wave_speed_bound(law, point);
}

/// Speeds of compression waves, m/s: that which bounds the step, and that of the skeleton by itself.
struct WaveSpeeds {
  double fastest = 0.0;
  double skeleton = 0.0;
};

/// Below the water table the particles of soil have other densities than its law, and water stiffens them.
/// @param stiffening  factor on the moduli of the law, 1
WaveSpeeds wave_speeds(const Case& scene, const Soil& soil, double stiffening) {
  const double of_law = p_wave_speed(scene, soil.law) * std::sqrt(stiffening);
  if (!scene.water || !soil.pores)
    return {of_law, of_law};
  const double modulus = materials::elasticity(soil.law).density * of_law * of_law;
  const double dry = std::sqrt(modulus / materials::dry_density(*soil.pores));
  const auto below = soils_below_table(scene);
  const bool wet = std::ranges::any_of(below, [&](const Soil& other) { return &other == &soil; });
  if (!wet)
    return {dry, dry};
  const auto speeds = materials::saturated_speeds(modulus, *soil.pores, scene.water->fluid);
  switch (soil.pores->drainage) {
  case materials::Drainage::coupled:
    return {speeds.fast, dry};
  case materials::Drainage::undrained:
    return {speeds.undrained, of_law};
  case materials::Drainage::drained:
    return {of_law, of_law};
  }
  return {of_law, of_law};
}

/// The critical step of a soil on cells of a size, at rest, s.
class CriticalStep {
public:
  CriticalStep(const Case& scene, const Soil& soil)
      : speeds_(wave_speeds(scene, soil, relaxation(scene.damping, soil.damping).unrelaxed())),
        undamped_speed_(wave_speeds(scene, soil, 1.0).fastest),
        damping_time_(damping_time(scene.damping, soil.damping)),
        share_(mpm_domain::share_of(scene.time.order)) {}

  MaterialStep on(double cell_size) const {
    const double of_skeleton = speeds_.skeleton / speeds_.fastest;
    const double least = mpm_domain::largest_courant_number * cell_size;
    return {
        mpm_domain::damped_step(least / speeds_.fastest, damping_time_ * of_skeleton * of_skeleton, share_),
        least / undamped_speed_};
  }

private:
  WaveSpeeds speeds_; ///< of soil whose constant damping has not had the time to relax
  double undamped_speed_;
  double damping_time_;
  double share_;
};

/// One for each soil of the domain, by its index.
std::map<std::size_t, CriticalStep> critical_steps(const Case& scene) {
  std::map<std::size_t, CriticalStep> steps;
  for (const Region& region : scene.regions)
    for (const std::size_t soil : soils_of(region))
      steps.try_emplace(soil, scene, scene.soils[soil]);
  return steps;
}

/// Adds what a material allows on the cells of a level.
void add_step(Level& level, const std::string& who, MaterialStep step) {
  const auto [known, is_new] = level.steps.try_emplace(who, step);
  known->second = {std::min(known->second.critical, step.critical),
                   std::min(known->second.undamped, step.undamped)};
  level.critical_dt = std::min(level.critical_dt, step.critical);
}

/// "soil 'sand'"; slices of a soil have its name.
std::string named(const Soil& soil) {
  return fmt::format("soil '{}'", soil.name);
}

bool in_region(const Case& scene, Point at) {
  return std::ranges::any_of(scene.regions,
                             [at](const Region& region) { return contains(region.polygon, at); });
}

/// Middles of the squares that fill [begin, end] side by side, from the square that holds `low` on, below
/// `high`.
std::vector<double> middles(double low, double high, double begin, double end, double spacing) {
  std::vector<double> list;
  const double before = std::floor((std::max(low, begin) - begin) / spacing);
  const auto middle = [&] { return begin + (before + static_cast<double>(list.size()) + 0.5) * spacing; };
  while (middle() < std::min(high, end))
    list.push_back(middle());
  return list;
}

/// Particles of a uniform mesh for which structures leave no room.
double squares_taken(const Case& scene, double spacing) {
  const std::vector<Polygon> all = outlines(scene);
  const std::vector<Polygon> regions = region_polygons(scene);
  const Box& box = scene.mesh.box;
  double count = 0.0;
  for (const Polygon& outline : all) {
    const Box part = box_of(outline);
    const auto rows = middles(part.y_min, part.y_max, box.y_min, box.y_max, spacing);
    for (const double x : middles(part.x_min, part.x_max, box.x_min, box.x_max, spacing))
      for (const double y : rows)
        // Two structures may share a square; that in which its middle lies counts it.
        if (contains(outline, {x, y}) &&
            !is_particle(mpm_domain::plot_of(regions, all, x, y, spacing), spacing) &&
            in_region(scene, {x, y}))
          ++count;
  }
  return count;
}

Level uniform_level(const Case& scene) {
  const Mesh& mesh = scene.mesh;
  double soil_area = 0.0;
  for (const Region& region : scene.regions)
    soil_area += area(region.polygon);
  const double spacing = mesh.particle_size();
  const mpm_domain::GridShape grid = grid_shape_of(scene);
  Level level{.cell_size = mesh.size,
              .particle_size = spacing,
              .cells = static_cast<double>(grid.nx - 1) * static_cast<double>(grid.ny - 1),
              .particles = std::round(soil_area / (spacing * spacing)) - squares_taken(scene, spacing),
              .nodes = static_cast<double>(grid.count()),
              .steps = {},
              .critical_dt = std::numeric_limits<double>::infinity()};
  for (const auto& [soil, step] : critical_steps(scene))
    add_step(level, named(scene.soils[soil]), step.on(mesh.size));
  return level;
}

/// Elastic structures bring particles and nodes of their own, on cells of the finest level.
void add_structures(const Case& scene, Level& finest) {
  constexpr double margin = 8.0; // nodes of a structure's lattice beyond its own cells
  const double h = finest.cell_size;
  for (const Structure& structure : scene.structures) {
    const Polygon& outline = structure.outline.corners;
    if (!structure.stiffness || outline.empty())
      continue;
    const double solid = area(outline) - (structure.hole ? area(structure.hole->corners) : 0.0);
    const Box box = box_of(outline);
    finest.particles += std::round(solid / (finest.particle_size * finest.particle_size));
    finest.nodes += std::round((box.width() / h + margin) * (box.height() / h + margin));
    const double step = critical_step(structure, h);
    add_step(finest, fmt::format("structure '{}'", structure.name), {step, step});
  }
}

/// Calls act(soil) for every particle of a leaf.
template <typename Act>
void for_particles(const Case& scene, const std::vector<Polygon>& regions,
                   const std::vector<Polygon>& structures, const mesh::Rectangle& leaf, double spacing,
                   const Act& act) {
  for (int j = 0; j < scene.mesh.particles_per_cell; ++j)
    for (int i = 0; i < scene.mesh.particles_per_cell; ++i) {
      const Point at{leaf.x_min + (i + 0.5) * spacing, leaf.y_min + (j + 0.5) * spacing};
      const mpm_domain::Plot plot = mpm_domain::plot_of(regions, structures, at.x, at.y, spacing);
      const auto region = std::ranges::find_if(scene.regions, [&](const Region& one) {
        return contains(one.polygon, at) || contains(one.polygon, {plot.x, plot.y});
      });
      if (region != scene.regions.end() && is_particle(plot, spacing))
        act(region->soil_at(at.y));
    }
}

} // namespace

mesh::Quadtree quadtree(const Case& scene) {
  const Mesh& mesh = scene.mesh;
  std::vector<mesh::Refinement> refinements;
  for (const Refinement& refine : mesh.refine)
    refinements.push_back({rectangle(refine.box), refine.level});
  return {mpm_domain::roots_of(grid_shape_of(scene)),
          mpm_domain::refinements_of(refinements, rectangle(mesh.box), mesh.size, scene.boundary.sides)};
}

std::vector<Level> levels(const Case& scene) {
  if (scene.mesh.refine.empty()) {
    Level level = uniform_level(scene);
    add_structures(scene, level);
    return {level};
  }
  const mesh::Quadtree tree = quadtree(scene);
  const std::map<std::size_t, CriticalStep> steps = critical_steps(scene);
  std::vector<Level> all;
  for (int level = 0; level <= tree.finest(); ++level)
    all.push_back(
        {.cell_size = tree.size(level),
         .particle_size = mpm_domain::particle_size(tree.size(level), scene.mesh.particles_per_cell),
         .steps = {},
         .critical_dt = std::numeric_limits<double>::infinity()});
  std::vector<std::set<std::size_t>> soils(all.size()); // whose particles touch cells of a level
  const mesh::Rectangle box = rectangle(scene.mesh.box);
  const double near = 1e-3 * all.back().cell_size;
  const std::vector<Polygon> regions = region_polygons(scene);
  const std::vector<Polygon> structures = outlines(scene);
  for (const mesh::Cell& leaf : tree.leaves()) {
    const auto level = static_cast<std::size_t>(leaf.level);
    const mesh::Rectangle cell = tree.rectangle(leaf);
    if (cell.x_min > box.x_max - near || cell.x_max < box.x_min + near || cell.y_min > box.y_max - near ||
        cell.y_max < box.y_min + near)
      continue;
    ++all[level].cells;
    // Particles at the edge of their cell take the step of finer cells beside it.
    const auto finest = static_cast<std::size_t>(
        tree.finest_in({cell.x_min - near, cell.y_min - near, cell.x_max + near, cell.y_max + near}));
    for_particles(scene, regions, structures, cell, all[level].particle_size, [&](std::size_t soil) {
      ++all[level].particles;
      soils[finest].insert(soil);
    });
  }
  const std::vector<mpm_domain::LevelLattice> lattices = mpm_domain::lattices_of(tree);
  for (std::size_t level = 0; level < all.size(); ++level) {
    all[level].nodes = static_cast<double>(lattices[level].lattice.count());
    for (const std::size_t soil : soils[level])
      add_step(all[level], named(scene.soils[soil]), steps.at(soil).on(all[level].cell_size));
  }
  add_structures(scene, all.back());
  return all;
}

double critical_step(const Structure& structure, double cell_size) {
  const materials::Elasticity elastic{structure.density, structure.stiffness->young,
                                      structure.stiffness->poisson};
  if (!(elastic.density > 0.0) || !(elastic.young > 0.0))
    return std::numeric_limits<double>::infinity();
  return mpm_domain::largest_courant_number * cell_size / elastic.p_wave_speed();
}

std::string by_level(std::span<const Level> levels, const std::function<double(double)>& value) {
  std::vector<std::string> values;
  std::vector<double> sizes;
  for (const Level& level : levels) {
    values.push_back(fmt::format("{:.3g}", value(level.cell_size)));
    sizes.push_back(level.cell_size);
  }
  return fmt::format("{} on cells of {} m", fmt::join(values, ", "), fmt::join(sizes, ", "));
}

} // namespace tremolo::scene
