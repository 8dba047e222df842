#include "mpm_domain/contact/rigid_body.hpp"

#include "mesh/polygon_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

std::vector<Vector> counter_clockwise(std::vector<Vector> corners) {
  if (!corners.empty() && mesh::signed_double_area(corners) < 0.0)
    std::ranges::reverse(corners);
  return corners;
}

std::vector<Vector> from(const Vector& origin, std::vector<Vector> corners) {
  for (Vector& corner : corners)
    corner = corner - origin;
  return corners;
}

} // namespace

RigidBody::RigidBody(const Structure& structure) : name_(structure.name) {
  const std::vector<Vector> outline = counter_clockwise(structure.outline);
  const std::vector<Vector> hole = counter_clockwise(structure.hole);
  const mesh::PolygonMeasures whole = mesh::measures(outline);
  const mesh::PolygonMeasures empty = mesh::measures(hole);
  const double area = whole.area - empty.area;
  if (!(area > 0.0))
    throw std::invalid_argument(
        fmt::format("the area of structure '{}' is {:.6g} m2; allowed: > 0", name_, area));
  if (!(structure.density > 0.0) || !std::isfinite(structure.density))
    throw std::invalid_argument(
        fmt::format("the density of structure '{}' is {:.6g} kg/m3; allowed: > 0", name_, structure.density));
  start_ = centre_ = {(whole.area * whole.x - empty.area * empty.x) / area,
                      (whole.area * whole.y - empty.area * empty.y) / area};
  const auto about_centre = [&](const mesh::PolygonMeasures& m) {
    const Vector to = Vector{m.x, m.y} - centre_;
    return m.polar + m.area * dot(to, to);
  };
  mass_ = structure.density * area;
  inertia_ = structure.density * (about_centre(whole) - (hole.empty() ? 0.0 : about_centre(empty)));
  corners_ = from(centre_, outline);
  hole_ = from(centre_, hole);
  surface_ = BodySurface(outline);
}

double RigidBody::kinetic_energy() const {
  return 0.5 * (mass_ * dot(motion_.velocity, motion_.velocity) + inertia_ * motion_.spin * motion_.spin);
}

std::vector<Vector> RigidBody::turned(const std::vector<Vector>& corners) const {
  const double c = std::cos(tilt_);
  const double s = std::sin(tilt_);
  std::vector<Vector> now;
  now.reserve(corners.size());
  for (const Vector& corner : corners)
    now.push_back({centre_.x + c * corner.x - s * corner.y, centre_.y + s * corner.x + c * corner.y});
  return now;
}

std::vector<Vector> RigidBody::hole() const {
  return turned(hole_);
}

void RigidBody::add_pressure(RigidLoad& load, const WaterAround& water) const {
  constexpr int parts = 32; // of an edge: the pressure bends where the phreatic surface meets it
  for (std::size_t i = 0, j = outline().size() - 1; i < outline().size(); j = i++) {
    const Vector& a = outline()[j];
    const Vector along = (outline()[i] - a) / parts;
    for (int part = 0; part < parts; ++part) {
      const Vector at = a + (part + 0.5) * along;
      const double p = std::max(water.unit_weight * (water.head.at(at.x, at.y).head - at.y), 0.0);
      const Vector push{-p * along.y, p * along.x}; // the outline runs counter-clockwise
      load.force += push;
      load.moment += cross(arm(at), push);
    }
  }
}

RigidLoad RigidBody::load(double gravity, const std::optional<WaterAround>& water) const {
  RigidLoad load{{0.0, -mass_ * gravity}, 0.0};
  if (!water)
    return load;
  const double* const level = water->head.level();
  if (level == nullptr) {
    add_pressure(load, *water);
    return load;
  }
  const mesh::PolygonMeasures below = mesh::measures(mesh::part_below(outline(), *level));
  const double buoyancy = water->unit_weight * below.area;
  load.force.y += buoyancy;
  load.moment += buoyancy * (below.x - centre_.x);
  return load;
}

void RigidBody::move(double dt) {
  centre_ += dt * motion_.velocity;
  tilt_ += dt * motion_.spin;
  surface_.place(turned(corners_));
}

std::vector<double> RigidBody::state() const {
  return {centre_.x, centre_.y, tilt_, motion_.velocity.x, motion_.velocity.y, motion_.spin};
}

void RigidBody::set_state(const std::vector<double>& state) {
  centre_ = {state.at(0), state.at(1)};
  tilt_ = state.at(2);
  motion_ = {{state.at(3), state.at(4)}, state.at(5)};
  surface_.place(turned(corners_));
}

} // namespace tremolo::mpm_domain
