#include "mpm_domain/gravity/mechanism.hpp"

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/surface_line.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// The index of the equivalent plastic strain in a law's state, or nothing.
std::optional<std::size_t> plastic_strain_place(const materials::Law& law) {
  const auto variables = materials::state_variables(law);
  const auto found =
      std::ranges::find(variables, "equivalent_plastic_strain", &materials::StateVariable::name);
  if (found == variables.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - variables.begin());
}

bool moves(const MovingPoint& point) {
  return std::hypot(point.velocity.x, point.velocity.y) >= 0.1;
}

} // namespace

std::vector<MovingPoint> mechanism_of(Domain& domain) {
  take_velocities_of_nodes(domain);
  std::vector<MovingPoint> points;
  double fastest = 0.0;
  for (const Particles& set : domain.sets_of_soil()) {
    const auto strain = plastic_strain_place(set.law);
    for (std::size_t k = 0; k < set.size(); ++k) {
      points.push_back({{set.x[k], set.y[k]},
                        2.0 * set.half_size,
                        {set.vx[k], set.vy[k]},
                        strain ? set.state[k * set.state_size + *strain] : 0.0});
      fastest = std::max(fastest, std::hypot(set.vx[k], set.vy[k]));
    }
  }
  if (fastest > 0.0)
    for (MovingPoint& point : points)
      point.velocity = point.velocity / fastest;
  return points;
}

std::optional<Extent> extent_of(std::span<const MovingPoint> mechanism) {
  if (std::ranges::none_of(mechanism, moves))
    return std::nullopt;
  SurfaceLine surface(std::ranges::max_element(mechanism, {}, &MovingPoint::size)->size);
  for (const MovingPoint& point : mechanism)
    surface.add(point.position, point.size);
  Extent extent{.x_min = INFINITY, .x_max = -INFINITY};
  for (const MovingPoint& point : mechanism) {
    if (!moves(point))
      continue;
    const double half = 0.5 * point.size;
    extent.x_min = std::min(extent.x_min, point.position.x - half);
    extent.x_max = std::max(extent.x_max, point.position.x + half);
    const double depth = surface.at(point.position.x) - (point.position.y - half);
    extent.depth = std::max(extent.depth, depth);
    extent.rows = std::max(extent.rows, depth / point.size);
  }
  return extent;
}

} // namespace tremolo::mpm_domain
