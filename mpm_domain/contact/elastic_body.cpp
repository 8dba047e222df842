#include "mpm_domain/contact/elastic_body.hpp"

#include "mpm_domain/particles/particles.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// act(set, particle) for all particles.
template <class Act>
void over_particles(std::span<const Particles> sets, const Act& act) {
  for (const Particles& set : sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      act(set, k);
}

/// Points along a closed line, no farther apart than a spacing.
std::vector<Vector> points_along(const std::vector<Vector>& corners, double spacing) {
  std::vector<Vector> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector from = corners[i];
    const Vector to = corners[(i + 1) % corners.size()];
    const int pieces = static_cast<int>(std::ceil(std::hypot(to.x - from.x, to.y - from.y) / spacing));
    for (int piece = 0; piece < pieces; ++piece) {
      const double t = static_cast<double>(piece) / pieces;
      points.push_back(from + t * (to - from));
    }
  }
  return points;
}

} // namespace

std::vector<ElasticBody::Follower> ElasticBody::followers(std::span<const Vector> points,
                                                          std::span<const Particles> sets) {
  std::vector<Follower> followers;
  for (const Vector& point : points) {
    Follower& follower = followers.emplace_back();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < sets.size(); ++s)
      for (std::size_t k = 0; k < sets[s].size(); ++k) {
        const Vector offset = point - Vector{sets[s].x[k], sets[s].y[k]};
        if (dot(offset, offset) < nearest) {
          nearest = dot(offset, offset);
          follower = {s, sets[s].id[k], offset};
        }
      }
  }
  return followers;
}

std::vector<Vector> ElasticBody::positions(std::span<const Follower> followers,
                                           std::span<const Particles> sets, double angle) {
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  std::vector<Vector> points;
  for (const Follower& follower : followers) {
    const Particles& set = sets[follower.set];
    const std::size_t k = set.index_of[follower.id];
    const Vector& offset = follower.offset;
    points.push_back({set.x[k] + c * offset.x - s * offset.y, set.y[k] + s * offset.x + c * offset.y});
  }
  return points;
}

ElasticBody::ElasticBody(const Structure& structure, std::size_t number, std::span<const Particles> sets,
                         double spacing)
    : number_(number) {
  const RigidBody at_start(structure);
  std::vector<Vector> points = points_along(at_start.outline(), spacing);
  hole_ = points_along(at_start.hole(), spacing);
  of_surface_ = followers(points, sets);
  of_hole_ = followers(hole_, sets);
  surface_ = BodySurface(std::move(points));
  over_particles(sets, [&](const Particles& set, std::size_t k) {
    mass_ += set.mass[k];
    start_ += set.mass[k] * Vector{set.x[k], set.y[k]};
  });
  start_ = start_ / mass_;
}

void ElasticBody::follow(std::span<const Particles> sets, RigidBody& whole) {
  double mass = 0.0;
  Vector moved; // sum m (x - X)
  Vector momentum;
  over_particles(sets, [&](const Particles& set, std::size_t k) {
    const double m = set.mass[k];
    mass += m;
    moved += m * Vector{set.x[k] - set.x_initial[k], set.y[k] - set.y_initial[k]};
    momentum += m * Vector{set.vx[k], set.vy[k]};
  });
  moved = moved / mass;
  const Vector velocity = momentum / mass;
  double sine = 0.0;
  double cosine = 0.0;
  double angular_momentum = 0.0;
  double inertia = 0.0;
  over_particles(sets, [&](const Particles& set, std::size_t k) {
    const double m = set.mass[k];
    const Vector before{set.x_initial[k] - start_.x, set.y_initial[k] - start_.y};
    const Vector now{set.x[k] - start_.x - moved.x, set.y[k] - start_.y - moved.y};
    sine += m * cross(before, now);
    cosine += m * dot(before, now);
    angular_momentum += m * cross(now, {set.vx[k] - velocity.x, set.vy[k] - velocity.y});
    inertia += m * dot(now, now);
  });
  const double tilt = std::atan2(sine, cosine);
  whole.set_state({whole.start().x + moved.x, whole.start().y + moved.y, tilt, velocity.x, velocity.y,
                   angular_momentum / inertia});
  surface_.place(positions(of_surface_, sets, tilt));
  hole_ = positions(of_hole_, sets, tilt);
}

} // namespace tremolo::mpm_domain
