#include "mpm_domain/lining/segment_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// A point counts while the nodes with soil hold at least this fraction of its hat functions.
constexpr double least_soil = 0.05;
/// A node counts as soil from this fraction of a full node's mass.
constexpr double counted_mass = 0.01;
/// Numbers that a segment seldom exceeds, to reserve memory.
constexpr std::size_t usual_nodes = 12, usual_freedoms = 30;

struct PointShares {
  std::array<NodeShare, 4> nodes; ///< of the cell; as many as `count`
  std::size_t count = 0;
  double sum = 0.0; ///< sum c_I N_I
  Vector position;  ///< X'
};

/// @param per_mass  1/(mass from which a node counts), m/kg
PointShares shares_at(const Vector& at, const Lattice& lattice, std::span<const double> mass,
                      double per_mass) {
  PointShares shares;
  const double x = (at.x - lattice.x0) / lattice.h;
  const double y = (at.y - lattice.y0) / lattice.h;
  const auto i0 = static_cast<int>(std::floor(x));
  const auto j0 = static_cast<int>(std::floor(y));
  for (int j = std::max(j0, 0); j <= std::min(j0 + 1, lattice.ny - 1); ++j)
    for (int i = std::max(i0, 0); i <= std::min(i0 + 1, lattice.nx - 1); ++i) {
      const std::size_t node = lattice.index(i, j);
      const double hat =
          (1.0 - std::abs(x - i)) * (1.0 - std::abs(y - j)) * std::min(1.0, mass[node] * per_mass);
      if (hat <= 0.0)
        continue;
      shares.nodes[shares.count++] = {node, hat};
      shares.sum += hat;
      shares.position += hat * Vector{lattice.x0 + i * lattice.h, lattice.y0 + j * lattice.h};
    }
  shares.position = shares.position / shares.sum;
  return shares;
}

} // namespace

std::vector<SegmentRows> find_rows(const LiningSurface& surface, const Beam& beam, const Lattice& lattice,
                                   std::span<const double> mass, double full) {
  const double per_mass = 1.0 / (counted_mass * full);
  std::vector<SegmentRows> all;
  all.reserve(surface.segments().size());
  for (std::size_t s = 0; s < surface.segments().size(); ++s) {
    const SurfaceSegment& segment = surface.segments()[s];
    SegmentRows rows{.segment = s, .soil = {}, .beam = {}, .normal = {}, .position = {}};
    rows.soil.reserve(usual_nodes);
    rows.beam.reserve(usual_freedoms);
    double counted = 0.0; // points
    for (const SurfacePoint& point : segment.points) {
      const PointShares shares = shares_at(position_of(point, beam), lattice, mass, per_mass);
      if (shares.sum < least_soil)
        continue;
      counted += 1.0;
      for (const NodeShare& of_node : std::span(shares.nodes).first(shares.count)) {
        auto found = std::ranges::find(rows.soil, of_node.node, &NodeShare::node);
        if (found == rows.soil.end())
          found = rows.soil.insert(found, {of_node.node, 0.0});
        found->share += of_node.share / shares.sum;
      }
      add_velocity(point, shares.position, 1.0, beam, rows.beam);
      rows.position += shares.position;
    }
    if (counted == 0.0)
      continue;
    for (NodeShare& of_node : rows.soil)
      of_node.share /= counted;
    for (BeamShare& of_beam : rows.beam)
      of_beam.velocity = of_beam.velocity / counted;
    rows.position = rows.position / counted;
    rows.normal = normal(segment, beam);
    all.push_back(std::move(rows));
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
