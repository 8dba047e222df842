#include "mpm_domain/boundary/springs/ground_springs.hpp"

#include "mpm_domain/ground.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// Cells from a centre within which springs grow no stiffer.
constexpr double least_cells = 2.0;

double rate_of(double stiffness, double impedance) {
  return impedance > 0.0 ? stiffness / impedance : 0.0;
}

} // namespace

GroundSprings::GroundSprings(const Ground& ground, std::span<BoundaryFace> faces) {
  const Spec& spec = ground.spec;
  std::size_t next_own = faces.size();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    BoundaryFace& face = faces[f];
    const auto of_side = std::ranges::find(spec.springs, face.side, &SideSprings::side);
    if (of_side == spec.springs.end() || !face.behind.has_dashpots)
      continue;
    const auto& [side, across, along, centre, lags, own_field] = *of_side;
    // With periodic sides the loads repeat as well, so that no point along the base is nearer to them than
    // another.
    const double beside = spec.sides == Sides::free_field ? face.position.x - centre.x : 0.0;
    const double distance =
        std::max(std::hypot(beside, face.position.y - centre.y), least_cells * spec.cell_size);
    const auto& [normal, p, s] = face.ground;
    const double modulus = s * s / face.density; // G
    const double k_n = across * modulus / distance;
    const double k_t = along * modulus / distance;
    face.behind.has_own_field = own_field;
    springs_.push_back({.face = f,
                        .field = own_field ? next_own++ : f,
                        .length = face.length,
                        .stiffness = by_direction(normal, k_n, k_t),
                        .lags = lags,
                        .rate = by_direction(normal, rate_of(k_n, p), rate_of(k_t, s))});
  }
}

void GroundSprings::exchange(const Exchange& at, std::span<SupportLoad> loads) {
  const double dt = started_ ? at.time - time_ : 0.0;
  work_ = 0.0;
  for (FaceSprings& spring : springs_) {
    const Vector now = at.field[spring.field].velocity;
    const Vector last = started_ ? spring.field_velocity : now;
    const Vector strained = spring.strained;
    const Vector v = at.mean[spring.face];
    const Vector moves = dt * (v - 0.5 * (last + now));
    const Vector lag = spring.moved - strained;
    spring.moved += moves;
    spring.strained =
        spring.lags ? Vector{strained.x + dt * spring.rate.x * lag.x, strained.y + dt * spring.rate.y * lag.y}
                    : spring.moved;
    spring.field_velocity = now;
    work_ += 0.5 * spring.length *
             (spring.stiffness.x * (strained.x + spring.strained.x) * moves.x +
              spring.stiffness.y * (strained.y + spring.strained.y) * moves.y);
    loads[spring.face].spring = spring.traction();
    loads[spring.face].far_end = now;
  }
  started_ = true;
  time_ = at.time;
}

const FaceSprings* GroundSprings::at(std::size_t face) const {
  const auto found = std::ranges::lower_bound(springs_, face, {}, &FaceSprings::face);
  return found != springs_.end() && found->face == face ? &*found : nullptr;
}

void GroundSprings::add_state(SavedNumbers& state) {
  state.add(started_, time_);
  for (FaceSprings& spring : springs_)
    state.add(spring.moved, spring.strained, spring.field_velocity);
}

} // namespace tremolo::mpm_domain
