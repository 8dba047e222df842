#include "mpm_domain/process/ranks/particles_at_start.hpp"

#include "mpm_domain/particles/share_out.hpp"
#include "mpm_domain/process/output/followed_point.hpp"
#include "mpm_domain/tiles/totals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

/// Discs around points, which hold the particle of the domain that is nearest to each, and its neighbours.
class NearPoints {
public:
  NearPoints(const Domain& domain, const scene::Case& scene) {
    for (const scene::Monitor& monitor : scene.monitors)
      points_.push_back(monitor.point);
    for (const scene::Line& line : scene.lines)
      for (const scene::Point& point : scene::points_along(line.from, line.to, line.spacing))
        points_.push_back(point);
    std::vector<double> nearest(points_.size(), -std::numeric_limits<double>::infinity()); // negative, m
    double widest = 0.0;
    for (const Particles& set : domain.sets_of_soil()) {
      widest = std::max(widest, 2.0 * set.half_size);
      for (std::size_t k = 0; k < set.size(); ++k)
        for (std::size_t p = 0; p < points_.size(); ++p)
          nearest[p] = std::max(nearest[p], -distance(p, set, k));
    }
    take_largest(domain, nearest);
    constexpr double rounding = 1.0 + 1e-9;
    for (const double negative : nearest)
      radius_.push_back(rounding * (FollowedPoint::reach_of_neighbours * widest - negative));
  }

  bool include(const Particles& set, std::size_t k) const {
    for (std::size_t p = 0; p < points_.size(); ++p)
      if (distance(p, set, k) <= radius_[p])
        return true;
    return false;
  }

private:
  double distance(std::size_t p, const Particles& set, std::size_t k) const {
    return std::hypot(set.x[k] - points_[p].x, set.y[k] - points_[p].y);
  }

  std::vector<scene::Point> points_;
  std::vector<double> radius_; ///< m
};

/// By set, the numbers of the particles of faces, rising.
std::vector<std::vector<std::uint32_t>> of_faces(const Domain& domain) {
  std::vector<std::vector<std::uint32_t>> ids(domain.sets.size());
  for (const BoundaryFace& face : domain.boundary.faces())
    ids[face.set].push_back(face.id);
  for (std::vector<std::uint32_t>& of_set : ids)
    std::ranges::sort(of_set);
  return ids;
}

} // namespace

std::vector<Particles> particles_at_start(const Domain& domain, const scene::Case& scene) {
  const NearPoints near(domain, scene);
  const std::vector<std::vector<std::uint32_t>> faces = of_faces(domain);
  const auto is_wanted = [&](std::size_t s, std::size_t k) {
    const Particles& set = domain.sets[s];
    return set.body.has_value() || std::ranges::binary_search(faces[s], set.id[k]) || near.include(set, k);
  };
  return gather_sets(domain, is_wanted, 0, [](std::size_t, std::size_t, std::vector<double>&) {}).sets;
}

} // namespace tremolo::mpm_domain
