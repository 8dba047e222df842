#include "scene/plan/prop/props.hpp"

#include "scene/plan/structures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

/// Mass, first and second moments of particles about a position.
struct Moments {
  double mass = 0.0;                   ///< kg/m
  double x = 0.0, y = 0.0;             ///< kg
  double xx = 0.0, xy = 0.0, yy = 0.0; ///< kg m
};

/// 1/m = (1 + d^T J^-1 d)/M of the particles of a lattice within a cell and a particle's side of a position,
/// d from their centroid to it and J their second moments about the centroid over M.
template <class DensityAt>
double mobility_of_particles(const Case& scene, const Point& at, const DensityAt& density_at) {
  const double h = contact_cell_size(scene);
  const double size = h / scene.mesh.particles_per_cell;
  const double reach = h + size;
  const auto first = [&](double position, double origin) {
    return std::floor((position - reach - origin) / size);
  };
  const auto count = static_cast<int>(std::ceil(2.0 * reach / size)) + 1;
  Moments sum;
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < count; ++i) {
      const Point p{scene.mesh.box.x_min + (first(at.x, scene.mesh.box.x_min) + i + 0.5) * size,
                    scene.mesh.box.y_min + (first(at.y, scene.mesh.box.y_min) + j + 0.5) * size};
      const double x = p.x - at.x;
      const double y = p.y - at.y;
      if (std::hypot(x, y) >= reach)
        continue;
      const double m = density_at(p) * size * size;
      sum = {sum.mass + m,       sum.x + m * x,      sum.y + m * y,
             sum.xx + m * x * x, sum.xy + m * x * y, sum.yy + m * y * y};
    }
  if (!(sum.mass > 0.0))
    return 0.0; // props_are_fastened refuses it
  const double x = sum.x / sum.mass;
  const double y = sum.y / sum.mass;
  const double xx = sum.xx / sum.mass - x * x;
  const double xy = sum.xy / sum.mass - x * y;
  const double yy = sum.yy / sum.mass - y * y;
  const double determinant = xx * yy - xy * xy;
  const double far = determinant > 1e-6 * (xx + yy) * (xx + yy)
                         ? (yy * x * x - 2.0 * xy * x * y + xx * y * y) / determinant
                         : 0.0;
  return (1.0 + far) / sum.mass;
}

double density_in(const Structure& structure, const Point& p) {
  const bool solid = contains(structure.outline.corners, p) &&
                     !(structure.hole && strictly_inside(structure.hole->corners, p));
  return solid ? structure.density : 0.0;
}

double density_of_soil(const Case& scene, const Point& p) {
  for (const Region& region : scene.regions)
    if (contains(region.polygon, p))
      return materials::elasticity(scene.soils[region.soil_at(p.y)].law).density;
  return 0.0;
}

/// m/kg
double mobility(const Case& scene, const Prop::End& end) {
  const auto found = std::ranges::find(scene.structures, end.structure, &Structure::name);
  if (found == scene.structures.end())
    return mobility_of_particles(scene, end.position,
                                 [&](const Point& p) { return density_of_soil(scene, p); });
  if (found->stiffness)
    return mobility_of_particles(scene, end.position, [&](const Point& p) { return density_in(*found, p); });
  const double solid = area(found->outline.corners) - (found->hole ? area(found->hole->corners) : 0.0);
  return 4.0 / (found->density * solid);
}

double length_of(const Prop& prop) {
  return std::hypot(prop.to.position.x - prop.from.position.x, prop.to.position.y - prop.from.position.y);
}

std::string end_text(const Prop::End& end) {
  return fmt::format("{} at ({:g}, {:g})",
                     end.structure.empty() ? "the ground" : fmt::format("'{}'", end.structure),
                     end.position.x, end.position.y);
}

std::string bears_text(const Prop& prop) {
  std::string text = prop.bears == mpm_domain::Bears::both ? "bears tension and compression"
                                                           : fmt::format("bears {} alone", name(prop.bears));
  if (prop.yield)
    text += fmt::format(", yields at {:.4g} kN/m", 1e-3 * *prop.yield);
  return prop.prestress ? fmt::format("{}, prestress {:.4g} kN/m", text, 1e-3 * *prop.prestress) : text;
}

} // namespace

std::vector<PlannedProp> plan_props(const Case& scene) {
  std::vector<PlannedProp> all;
  for (const Prop& prop : scene.props)
    all.push_back(
        {prop.name, length_of(prop),
         1.0 / std::sqrt(prop.stiffness * (mobility(scene, prop.from) + mobility(scene, prop.to)))});
  return all;
}

std::string props_effect_text(const Case& scene) {
  std::string text;
  for (const Prop& prop : scene.props)
    text += fmt::format("{}'{}', {}", text.empty() ? "" : "; ", prop.name, bears_text(prop));
  return text.empty() ? "no [[prop]] stands while the ground is shaken" : text;
}

std::string props_text(const Case& scene, const std::vector<PlannedProp>& props) {
  std::string text;
  for (std::size_t n = 0; n < props.size(); ++n) {
    const Prop& prop = scene.props[n];
    text += fmt::format("  {:<18}from {} to {} m, {:.4g} m long, {:.4g} N/m2\n"
                        "  {:<18}{}; allows steps of about {:.2g} s\n",
                        prop.name, end_text(prop.from), end_text(prop.to), props[n].length, prop.stiffness,
                        "", bears_text(prop), props[n].critical_step);
  }
  return text;
}

} // namespace tremolo::scene
