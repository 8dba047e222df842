#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::scene {

void box_fits_lattice(const Case& scene, Findings& findings) {
  if (!findings.sound("mesh.box") || !findings.sound("mesh.size") ||
      !findings.sound("mesh.particles_per_cell"))
    return;
  const Box& box = scene.mesh.box;
  if (!(box.width() > 0.0) || !(box.height() > 0.0)) {
    findings.add(
        "mesh.box",
        fmt::format("'box' is {} m wide and {} m high, must be [x_min, y_min, x_max, y_max] with both > 0",
                    box.width(), box.height()));
    return;
  }
  const double spacing = scene.mesh.particle_size();
  constexpr double most_particles = 1e9;
  if (const double count = box.width() / spacing * (box.height() / spacing); !(count <= most_particles)) {
    findings.add("mesh.size",
                 fmt::format("'size' = {} gives {:.3g} particles in the box, must be at most {:g}",
                             scene.mesh.size, count, most_particles));
    return;
  }
  const auto check_multiple = [&](const char* what, double length, const char* of, double size) {
    const double count = length / size;
    if (std::round(count) < 1.0 || std::abs(count - std::round(count)) > 1e-6)
      findings.add("mesh.box", fmt::format("the {} of 'box', {} m, must be a multiple of the {}, {} m", what,
                                           length, of, size));
  };
  // Supports of the gravity stage and their tractions act at nodes: both sides must lie on a column of nodes.
  check_multiple("width", box.width(), "cell size", scene.mesh.size);
  check_multiple("height", box.height(), "particle spacing", spacing);
}

} // namespace tremolo::scene
