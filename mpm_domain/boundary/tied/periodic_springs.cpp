#include "mpm_domain/boundary/tied/periodic_springs.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/spec/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

std::size_t count_of(std::span<const BoundaryFace> faces, Side side) {
  return static_cast<std::size_t>(std::ranges::count(faces, side, &BoundaryFace::side));
}

/// rho h / (4 dt^2) of the soil at a face, Pa/m.
double stiffness_of(const Ground& ground, const BoundaryFace& face) {
  const Particles& set = ground.sets[face.set];
  const double h = ground.lattice(set.level).h;
  const double density = materials::elasticity(set.law).density;
  const Scheme& scheme = ground.spec.scheme;
  const double dt =
      scheme.dt.value_or(scheme.fraction * largest_courant_number * h * density / face.ground.impedance_p);
  return 0.25 * density * h / (dt * dt);
}

/// Displacement since rest of the particle that a face rides on, m. Another rank may have the particle.
Vector displacement(const Exchange& at, std::size_t face) {
  const BoundaryFace& one = at.faces[face];
  return (at.soil.empty() ? soil_at(one, at.ground.sets[one.set]) : at.soil[face]).displacement;
}

} // namespace

PeriodicSprings::PeriodicSprings(const Ground& ground, std::span<BoundaryFace> faces) {
  const std::size_t left = count_of(faces, Side::left);
  const std::size_t right = count_of(faces, Side::right);
  const auto refuse = [](const std::string& why) {
    throw std::invalid_argument("periodic springs tie particles of the left side to those of the right: " +
                                why);
  };
  if (left != right)
    refuse(fmt::format("there are {} on the left and {} on the right", left, right));
  for (std::size_t f = 0; f < left; ++f) {
    BoundaryFace& a = faces[f];
    BoundaryFace& b = faces[left + f];
    if (std::abs(a.position.y - b.position.y) > 1e-6 * a.length ||
        std::abs(a.length - b.length) > 1e-6 * a.length)
      refuse(fmt::format("the one at y = {:.6g} m, {:.6g} m high, has none like it", a.position.y, a.length));
    stiffness_.push_back(std::min(stiffness_of(ground, a), stiffness_of(ground, b)));
    for (BoundaryFace* face : {&a, &b}) {
      face->behind.has_dashpots = false;
      face->behind.is_tied = true;
    }
  }
}

void PeriodicSprings::exchange(const Exchange& at, std::span<SupportLoad> loads) {
  const std::size_t pairs = stiffness_.size();
  for (std::size_t left = 0; left < pairs; ++left) {
    const std::size_t right = pairs + left;
    const Vector u_left = displacement(at, left);
    const Vector u_right = displacement(at, right);
    const Vector pull = {stiffness_[left] * (u_right.x - u_left.x),
                         stiffness_[left] * (u_right.y - u_left.y)};
    loads[left].driven = pull;
    loads[right].driven = {-pull.x, -pull.y};
    at.field[left] = {at.seen[right], {}};
    at.field[right] = {at.seen[left], {}};
  }
}

} // namespace tremolo::mpm_domain
