#include "mpm_domain/section/cut.hpp"

#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/spec/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

// Reach around a cut, in cells: a kernel reaches a cell and a half along each axis, the squares of nodes half
// a cell more, and strain moves particles a little.
constexpr double guide_reach = 1.0;
constexpr double bearing_reach = 3.5;
/// Reach beyond the ends of the cut, in cells, where other parts of the body may lie.
constexpr double beyond_ends = 1.0;

Vector unit(const CutLine& line) {
  const Vector way = line.to - line.from;
  return way / std::hypot(way.x, way.y);
}

Vector middle(const CutLine& line) {
  return 0.5 * (line.from + line.to);
}

/// Weights of a particle's box on its lattice in one direction (kernel.hpp), no wider than two cells.
Weights weights_along(double x, double origin, double h, double half_side) {
  return cell_weights(x, Axis(origin, h), std::min(half_side, h));
}

/// F and M_c.
struct Passing {
  Vector force;
  double moment = 0.0;
};

/// Adds the contribution of a particle.
void add(Passing& to, const Particles& p, std::size_t k, const Lattice& lattice, const CutPosition& cut) {
  const Vector sides = half_sides(p, k);
  const Weights wx = weights_along(p.x[k], lattice.x0, lattice.h, sides.x);
  const Weights wy = weights_along(p.y[k], lattice.y0, lattice.h, sides.y);
  const Vector axis = cut.axis();
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const Vector arm =
          Vector{lattice.x0 + lattice.h * (wx.base + i), lattice.y0 + lattice.h * (wy.base + j)} - cut.middle;
      const double weight = p.volume[k] * share_ahead(dot(arm, axis), axis, lattice.h);
      const Vector slope{weight * wx.g[i] * wy.s[j], weight * wx.s[i] * wy.g[j]};
      const Vector force{p.sxx[k] * slope.x + p.sxy[k] * slope.y, p.sxy[k] * slope.x + p.syy[k] * slope.y};
      to.force += force;
      to.moment += cross(arm, force);
    }
}

} // namespace

double share_ahead(double ahead, const Vector& normal, double h) {
  // Along the normal the square is a trapezium of half widths wide + narrow at its foot and wide - narrow.
  const double wide = 0.5 * h * std::max(std::abs(normal.x), std::abs(normal.y));
  const double narrow = 0.5 * h * std::min(std::abs(normal.x), std::abs(normal.y));
  constexpr double nearly_none = 1e-6;
  if (narrow < nearly_none * h)
    return std::clamp(0.5 + 0.5 * ahead / wide, 0.0, 1.0);
  if (std::abs(ahead) >= wide + narrow)
    return ahead > 0.0 ? 1.0 : 0.0;
  const auto ramp = [](double z) { return z > 0.0 ? 0.5 * z * z : 0.0; };
  return (ramp(ahead + wide + narrow) - ramp(ahead + wide - narrow) - ramp(ahead - wide + narrow) +
          ramp(ahead - wide - narrow)) /
         (4.0 * wide * narrow);
}

Cut::Cut(const CutLine& line, std::span<const Particles> sets, double h)
    : line_(line), length_(std::hypot(line.to.x - line.from.x, line.to.y - line.from.y)) {
  if (!(length_ > 0.0))
    throw std::invalid_argument(
        fmt::format("a cut at ({:.6g}, {:.6g}) has no length", line.from.x, line.from.y));
  const CutPosition start{middle(line), unit(line), 0.0};
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t k = 0; k < sets[s].size(); ++k) {
      const Vector offset = Vector{sets[s].x[k], sets[s].y[k]} - start.middle;
      const double ahead = std::abs(dot(offset, start.axis()));
      if (std::abs(dot(offset, start.along)) > 0.5 * length_ + beyond_ends * h || ahead > bearing_reach * h)
        continue;
      bearing_.push_back({s, sets[s].id[k], offset});
      if (ahead <= guide_reach * h)
        guides_.push_back(bearing_.back());
    }
  if (guides_.size() < 2)
    throw std::invalid_argument(
        fmt::format("the cut from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) does not go through the structure",
                    line.from.x, line.from.y, line.to.x, line.to.y));
}

CutPosition Cut::position(std::span<const Particles> sets, double back) const {
  const auto at = [&](const Neighbour& guide) {
    const Particles& set = sets[guide.set];
    const std::size_t k = set.index_of[guide.id];
    return Vector{set.x[k] - back * set.vx[k], set.y[k] - back * set.vy[k]};
  };
  const double share = 1.0 / static_cast<double>(guides_.size());
  Vector before; // mean position from the middle of the cut at the start
  Vector now;
  for (const Neighbour& guide : guides_) {
    const Vector x = at(guide);
    before += share * guide.offset;
    now += share * x;
  }
  double sine = 0.0;
  double cosine = 0.0;
  for (const Neighbour& guide : guides_) {
    const Vector arm = guide.offset - before;
    const Vector turned = at(guide) - now;
    sine += cross(arm, turned);
    cosine += dot(arm, turned);
  }
  const double turn = std::atan2(sine, cosine);
  const double s = std::sin(turn);
  const double c = std::cos(turn);
  const Vector along = unit(line_);
  return {{now.x - c * before.x + s * before.y, now.y - s * before.x - c * before.y},
          {c * along.x - s * along.y, s * along.x + c * along.y},
          turn};
}

SectionForces Cut::forces(std::span<const Particles> sets, const Lattice& lattice) const {
  const CutPosition cut = position(sets);
  Passing passing;
  for (const Neighbour& one : bearing_)
    add(passing, sets[one.set], sets[one.set].index_of[one.id], lattice, cut);
  return {dot(passing.force, cut.axis()), -dot(passing.force, cut.along), passing.moment};
}

} // namespace tremolo::mpm_domain
