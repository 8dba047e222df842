#include "scene/rules/particle_positions.hpp"

#include "mpm_domain/spec/plot.hpp"
#include "scene/plan/structures.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

struct Search {
  const mesh::Quadtree& tree;
  const mesh::Rectangle& box;
  int per_direction; ///< particles of a cell
  std::vector<Polygon> regions;
  std::vector<Polygon> structures;
  const std::function<bool(const ParticlePosition&)>& found;

  bool at(Point middle, double size_of_square) const {
    const auto plot = mpm_domain::plot_of(regions, structures, middle.x, middle.y, size_of_square);
    return is_particle(plot, size_of_square) && found({middle, {plot.x, plot.y}});
  }

  bool in(const mesh::Cell& cell) const {
    const mesh::Rectangle place = tree.rectangle(cell);
    if (place.x_max < box.x_min || place.x_min > box.x_max || place.y_max < box.y_min ||
        place.y_min > box.y_max)
      return false;
    const int parts = tree.is_cut(cell) ? 2 : per_direction;
    const double size = (place.x_max - place.x_min) / parts;
    for (int j = 0; j < parts; ++j)
      for (int i = 0; i < parts; ++i)
        if (tree.is_cut(cell) ? in({cell.level + 1, 2 * cell.i + i, 2 * cell.j + j})
                              : at({place.x_min + (i + 0.5) * size, place.y_min + (j + 0.5) * size}, size))
          return true;
    return false;
  }
};

/// The root cell at a distance from the first one, of `count`.
int root_at(double distance, double size, int count) {
  return static_cast<int>(std::clamp(std::floor(distance / size), 0.0, count - 1.0));
}

} // namespace

bool find_particle_position(const Case& scene, const mesh::Quadtree& tree, const mesh::Rectangle& box,
                            const std::function<bool(const ParticlePosition&)>& found) {
  const mesh::Roots& roots = tree.roots();
  const Search search{tree, box, scene.mesh.particles_per_cell, region_polygons(scene), outlines(scene),
                      found};
  const int last_i = root_at(box.x_max - roots.x0, roots.h, roots.nx);
  const int last_j = root_at(box.y_max - roots.y0, roots.h, roots.ny);
  for (int j = root_at(box.y_min - roots.y0, roots.h, roots.ny); j <= last_j; ++j)
    for (int i = root_at(box.x_min - roots.x0, roots.h, roots.nx); i <= last_i; ++i)
      if (search.in({0, i, j}))
        return true;
  return false;
}

} // namespace tremolo::scene
