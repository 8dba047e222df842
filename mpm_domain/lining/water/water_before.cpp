#include "mpm_domain/lining/water/water_before.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/kernel/kernel.hpp"
#include "mpm_domain/lining/water/water_load.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// Sums over the particles whose water moves with their grains.
struct Sealed {
  double volume = 0.0; ///< sum V S, m2
  Vector force;        ///< sum V p_e grad S, N/m
};

/// The nodes of segments, and the cells with particles that reach one of them.
class SegmentWindow {
public:
  SegmentWindow(std::span<const SegmentRows> rows, const NodeWindow& window, const Lattice& lattice)
      : window_(window), has_(window.count(), 0),
        reaches_(cells_across() * static_cast<std::size_t>(window.rows + reach), 0) {
    const std::size_t first = lattice.index(0, 0);
    const auto columns = static_cast<std::size_t>(lattice.nx);
    for (const SegmentRows& of : rows)
      for (const NodeShare& at : of.soil) {
        const auto i = static_cast<int>((at.node - first) % columns);
        const auto j = static_cast<int>((at.node - first) / columns);
        if (!window.has(i, j) || has_[window.index(i, j)] != 0)
          continue;
        has_[window.index(i, j)] = 1;
        for (int b = j - 2; b <= j + 1; ++b)
          for (int a = i - 2; a <= i + 1; ++a)
            reaches_[cell(a, b)] = 1;
      }
  }
  bool has(int i, int j) const { return window_.has(i, j) && has_[window_.index(i, j)] != 0; }
  /// Whether particles of a cell, by its lower left node, reach a node of a segment.
  bool is_reached_from(int i, int j) const {
    const int a = i - window_.i0 + 2;
    const int b = j - window_.j0 + 2;
    return a >= 0 && b >= 0 && a < window_.columns + reach && b < window_.rows + reach &&
           reaches_[cell(i, j)] != 0;
  }

private:
  static constexpr int reach = 3; // cells beyond the window, on both sides together

  std::size_t cells_across() const { return static_cast<std::size_t>(window_.columns + reach); }
  std::size_t cell(int i, int j) const {
    return static_cast<std::size_t>(j - window_.j0 + 2) * cells_across() +
           static_cast<std::size_t>(i - window_.i0 + 2);
  }

  const NodeWindow& window_;
  std::vector<unsigned char> has_, reaches_;
};

std::vector<Sealed> sum_sealed(const Ground& ground, std::span<const NearParticle> near,
                               const NodeWindow& window, const SegmentWindow& nodes) {
  const Lattice& lattice = ground.finest_lattice();
  const Axis x_axis(lattice.x0, lattice.h);
  const Axis y_axis(lattice.y0, lattice.h);
  std::vector<Sealed> sums(window.count());
  for (const auto& [set, k] : near) {
    const Particles& p = ground.sets[set];
    if (!p.traits.wet || p.traits.flowing)
      continue;
    if (!nodes.is_reached_from(static_cast<int>(std::floor(x_axis.cells(p.x[k]))),
                               static_cast<int>(std::floor(y_axis.cells(p.y[k])))))
      continue;
    const double l = std::min(p.half_size, lattice.h);
    const Weights wx = cell_weights(p.x[k], x_axis, l);
    const Weights wy = cell_weights(p.y[k], y_axis, l);
    const double excess = excess_pressure(p, k);
    for (std::size_t b = 0; b < 4; ++b)
      for (std::size_t a = 0; a < 4; ++a) {
        const int i = wx.base + static_cast<int>(a);
        const int j = wy.base + static_cast<int>(b);
        if (!nodes.has(i, j))
          continue;
        Sealed& sum = sums[window.index(i, j)];
        sum.volume += p.volume[k] * wx.s[a] * wy.s[b];
        sum.force.x += p.volume[k] * excess * wx.g[a] * wy.s[b];
        sum.force.y += p.volume[k] * excess * wx.s[a] * wy.g[b];
      }
  }
  return sums;
}

bool flows_at(const Grid& grid, std::size_t node) {
  return grid.traits.flowing && grid.water_mass[node] > 1e-9 * grid.mass[node];
}

} // namespace

WaterBefore find_water_before(const Ground& ground, std::span<const NearParticle> near,
                              const mesh::Rectangle& box, std::span<const SegmentRows> rows, double dt) {
  WaterBefore before;
  if (!ground.has_water())
    return before;
  const double density = ground.spec.water->fluid.density;
  const Lattice& lattice = ground.finest_lattice();
  const Grid& grid = ground.grid;
  const double empty = empty_mass(ground);
  const NodeWindow window = nodes_around(lattice, box);
  const SegmentWindow nodes(rows, window, lattice);
  const std::vector<Sealed> sealed = sum_sealed(ground, near, window, nodes);
  for (int j = window.j0; j < window.j0 + window.rows; ++j)
    for (int i = window.i0; i < window.i0 + window.columns; ++i) {
      const std::size_t n = lattice.index(i, j);
      if (!nodes.has(i, j) || grid.mass[n] <= empty)
        continue;
      const Sealed& of_sealed = sealed[window.index(i, j)];
      const bool flows = flows_at(grid, n);
      const double flowing = flows ? density * grid.wet_volume[n] : 0.0;
      const double mass = density * of_sealed.volume + flowing;
      if (!(mass > 0.0))
        continue;
      const Vector v = grid.velocity_before(n);
      Vector push = dt * of_sealed.force;
      if (flows)
        push = {push.x + grid.water_mass[n] * (grid.wx_before[n] - v.x) + dt * grid.water_force_x[n],
                push.y + grid.water_mass[n] * (grid.wy_before[n] - v.y) + dt * grid.water_force_y[n]};
      before.nodes.push_back({n, mass, v + push / mass});
    }
  for (const SegmentRows& of : rows)
    before.least.push_back(ground.spec.water->fluid.cavitation_pressure - rest_pressure(ground, of.position));
  return before;
}

std::vector<NodeFlow> find_flows(const Ground& ground, std::span<const SegmentRows> rows, double dt) {
  std::vector<NodeFlow> flows;
  if (!ground.has_flow())
    return flows;
  const Grid& grid = ground.grid;
  for (const SegmentRows& of : rows)
    for (const auto& [node, share] : of.soil) {
      if (!flows_at(grid, node))
        continue;
      auto found = std::ranges::lower_bound(flows, node, {}, &NodeFlow::node);
      if (found == flows.end() || found->node != node)
        found = flows.insert(found, {node, {}, grid.mass[node], grid.water_mass[node], 1.0});
      found->normal += share * of.normal;
    }
  for (NodeFlow& of : flows) {
    const double length = std::hypot(of.normal.x, of.normal.y);
    of.normal = of.normal / length;
    const double full = ground.spec.water->fluid.density * grid.wet_volume[of.node];
    const double ratio = of.water_mass / of.solid_mass;
    of.drag += dt * (1.0 + ratio) * of.water_mass / (full * full) * grid.resistance[of.node];
  }
  return flows;
}

void stop_flow(Ground& ground, std::span<const NodeFlow> flows) {
  Grid& grid = ground.grid;
  for (const NodeFlow& of : flows) {
    const Vector& n = of.normal;
    const double grains = dot(n, grid.velocity_after(of.node));
    const double water = dot(n, {grid.wx_after[of.node], grid.wy_after[of.node]});
    const double both = (of.solid_mass * grains + of.water_mass * water) / of.mass();
    grid.vx_after[of.node] += (both - grains) * n.x;
    grid.vy_after[of.node] += (both - grains) * n.y;
    grid.wx_after[of.node] += (both - water) * n.x;
    grid.wy_after[of.node] += (both - water) * n.y;
  }
}

} // namespace tremolo::mpm_domain
