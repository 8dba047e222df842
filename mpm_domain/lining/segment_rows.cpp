#include "mpm_domain/lining/segment_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// A point counts while the nodes with soil have this part of its hats.
constexpr double least_soil = 0.05;
/// Part of a full node's mass from which a node counts as one of soil.
constexpr double counted_mass = 0.01;

struct PointShares {
  std::array<NodeShare, 4> nodes; ///< of the cell; as many as `count`
  std::size_t count = 0;
  double sum = 0.0; ///< sum c_I N_I
  Vector place;     ///< X'
};

PointShares shares_at(const Vector& at, const Lattice& lattice, std::span<const double> mass, double full) {
  PointShares shares;
  const double x = (at.x - lattice.x0) / lattice.h;
  const double y = (at.y - lattice.y0) / lattice.h;
  const auto i0 = static_cast<int>(std::floor(x));
  const auto j0 = static_cast<int>(std::floor(y));
  for (int j = std::max(j0, 0); j <= std::min(j0 + 1, lattice.ny - 1); ++j)
    for (int i = std::max(i0, 0); i <= std::min(i0 + 1, lattice.nx - 1); ++i) {
      const std::size_t node = lattice.index(i, j);
      const double hat = (1.0 - std::abs(x - i)) * (1.0 - std::abs(y - j)) *
                         std::min(1.0, mass[node] / (counted_mass * full));
      if (hat <= 0.0)
        continue;
      shares.nodes[shares.count++] = {node, hat};
      shares.sum += hat;
      shares.place = {shares.place.x + hat * (lattice.x0 + i * lattice.h),
                      shares.place.y + hat * (lattice.y0 + j * lattice.h)};
    }
  shares.place = {shares.place.x / shares.sum, shares.place.y / shares.sum};
  return shares;
}

} // namespace

std::vector<SegmentRows> find_rows(const LiningSurface& surface, const Beam& beam, const Lattice& lattice,
                                   std::span<const double> mass, double full) {
  std::vector<SegmentRows> all;
  for (std::size_t s = 0; s < surface.segments().size(); ++s) {
    const SurfaceSegment& segment = surface.segments()[s];
    std::vector<std::pair<const SurfacePoint*, PointShares>> counted;
    for (const SurfacePoint& point : segment.points)
      if (PointShares shares = shares_at(place(point, beam), lattice, mass, full); shares.sum >= least_soil)
        counted.emplace_back(&point, std::move(shares));
    if (counted.empty())
      continue;
    SegmentRows& rows = all.emplace_back();
    rows.segment = s;
    rows.normal = normal(segment, beam);
    for (const auto& [point, shares] : counted) {
      const double share = 1.0 / static_cast<double>(counted.size());
      for (const NodeShare& of_node : std::span(shares.nodes).first(shares.count)) {
        auto found = std::ranges::find(rows.soil, of_node.node, &NodeShare::node);
        if (found == rows.soil.end())
          found = rows.soil.insert(found, {of_node.node, 0.0});
        found->share += share * of_node.share / shares.sum;
      }
      add_velocity(*point, shares.place, share, beam, rows.beam);
      rows.place = {rows.place.x + share * shares.place.x, rows.place.y + share * shares.place.y};
    }
  }
  return all;
}

Vector soil_velocity(const SegmentRows& rows, std::span<const double> wx, std::span<const double> wy) {
  Vector velocity{};
  for (const auto& [node, share] : rows.soil)
    velocity = {velocity.x + share * wx[node], velocity.y + share * wy[node]};
  return velocity;
}

Vector beam_velocity(const SegmentRows& rows, std::span<const double> v) {
  Vector velocity{};
  for (const auto& [dof, of_one] : rows.beam)
    velocity = {velocity.x + v[dof] * of_one.x, velocity.y + v[dof] * of_one.y};
  return velocity;
}

} // namespace tremolo::mpm_domain
