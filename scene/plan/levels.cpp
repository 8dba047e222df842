#include "scene/plan/levels.hpp"

#include "scene/plan/layers.hpp"
#include "scene/plan/plan.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::scene {

namespace {

constexpr int padding = 6;                      // cells around the box
constexpr double largest_courant_number = 0.65; // 2D uGIMP with dashpots at corners

mesh::Rectangle rectangle(const Box& box) {
  return {box.x_min, box.y_min, box.x_max, box.y_max};
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

/// c_p by region, m/s.
std::vector<double> p_wave_speeds(const Case& scene) {
  std::vector<double> speeds;
  for (const Region& region : scene.regions)
    speeds.push_back(p_wave_speed(scene, scene.soils[region.soil].law));
  return speeds;
}

Level uniform_level(const Case& scene) {
  const Mesh& mesh = scene.mesh;
  double soil_area = 0.0;
  for (const Region& region : scene.regions)
    soil_area += area(region.polygon);
  const double spacing = mesh.size / mesh.particles_per_cell;
  const auto cells = [&](double length) { return std::ceil(length / mesh.size - 1e-6) + 2 * padding; };
  const double count = cells(mesh.box.width()) * cells(mesh.box.height());
  double fastest = 0.0;
  for (const double speed : p_wave_speeds(scene))
    fastest = std::max(fastest, speed);
  return {.cell_size = mesh.size,
          .particle_size = spacing,
          .cells = count,
          .particles = std::round(soil_area / (spacing * spacing)),
          .nodes = count,
          .critical_dt = largest_courant_number * mesh.size / fastest};
}

/// The block of nodes that encloses cells.
struct Block {
  mesh::Rectangle box{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                      -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void take(const mesh::Rectangle& cell) {
    box = {std::min(box.x_min, cell.x_min), std::min(box.y_min, cell.y_min), std::max(box.x_max, cell.x_max),
           std::max(box.y_max, cell.y_max)};
  }
  double nodes(double h) const {
    const auto along = [h](double length) { return std::max(0.0, length / h + 2 * padding); };
    return along(box.x_max - box.x_min) * along(box.y_max - box.y_min);
  }
};

/// Calls act(region) for every particle of a leaf that lies in one.
template <typename Act>
void for_particles(const Case& scene, const mesh::Rectangle& leaf, double spacing, const Act& act) {
  for (int j = 0; j < scene.mesh.particles_per_cell; ++j)
    for (int i = 0; i < scene.mesh.particles_per_cell; ++i) {
      const Point at{leaf.x_min + (i + 0.5) * spacing, leaf.y_min + (j + 0.5) * spacing};
      const auto region =
          std::ranges::find_if(scene.regions, [&](const Region& one) { return contains(one.polygon, at); });
      if (region != scene.regions.end())
        act(static_cast<std::size_t>(region - scene.regions.begin()));
    }
}

} // namespace

mesh::Quadtree quadtree(const Case& scene) {
  const Mesh& mesh = scene.mesh;
  std::vector<mesh::Refinement> refinements;
  for (const Refinement& refine : mesh.refine)
    refinements.push_back({rectangle(refine.box), refine.level});
  const mesh::Roots roots{.x0 = mesh.box.x_min,
                          .y0 = mesh.box.y_min,
                          .h = mesh.size,
                          .nx = static_cast<int>(std::lround(mesh.box.width() / mesh.size)),
                          .ny = static_cast<int>(std::ceil(mesh.box.height() / mesh.size - 1e-6))};
  return {roots, mesh::beyond_edges(refinements, rectangle(mesh.box), 1e-6 * mesh.size, true)};
}

std::vector<Level> levels(const Case& scene) {
  if (scene.mesh.refine.empty())
    return {uniform_level(scene)};
  const mesh::Quadtree tree = quadtree(scene);
  const std::vector<double> speeds = p_wave_speeds(scene);
  std::vector<Level> all;
  for (int level = 0; level <= tree.finest(); ++level)
    all.push_back({.cell_size = tree.size(level),
                   .particle_size = tree.size(level) / scene.mesh.particles_per_cell,
                   .critical_dt = std::numeric_limits<double>::infinity()});
  std::vector<Block> blocks(all.size());
  for (const mesh::Cell& leaf : tree.leaves()) {
    const auto level = static_cast<std::size_t>(leaf.level);
    const mesh::Rectangle cell = tree.rectangle(leaf);
    ++all[level].cells;
    blocks[level].take(cell);
    // Particles at the edge of their cell take the step of finer cells beside it.
    const double near = 1e-3 * all.back().cell_size;
    const auto finest = static_cast<std::size_t>(
        tree.finest_in({cell.x_min - near, cell.y_min - near, cell.x_max + near, cell.y_max + near}));
    for_particles(scene, cell, all[level].particle_size, [&](std::size_t region) {
      ++all[level].particles;
      all[finest].critical_dt =
          std::min(all[finest].critical_dt, largest_courant_number * all[finest].cell_size / speeds[region]);
    });
  }
  for (std::size_t level = 0; level < all.size(); ++level)
    all[level].nodes = blocks[level].nodes(all[level].cell_size);
  return all;
}

double critical_time_step(const Case& scene, std::span<const Level> levels) {
  double critical = std::numeric_limits<double>::infinity();
  double steps = 1.0; // of a level in one of the coarsest
  for (const Level& level : levels) {
    critical = std::min(critical, steps * level.critical_dt);
    if (scene.time.subcycle)
      steps *= 2.0;
  }
  const auto below = ground_below_base(scene);
  if (below && scene.boundary.base.absorber == Absorber::matched_layer)
    critical = std::min(critical, largest_courant_number * scene.mesh.size / below->p_wave_speed());
  return critical;
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
