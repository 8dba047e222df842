#include "mpm_domain/water/mixture_update.hpp"

#include "mpm_domain/kernel/lanes.hpp"
#include "mpm_domain/water/mixture_kick.hpp"
#include "mpm_domain/water/water_scatter.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// A node with less than this share of the mass of an empty node of soil has no water.
double empty_water(const Ground& ground) {
  return 0.1 * empty_mass(ground);
}

double density_of_water(const Ground& ground) {
  return ground.spec.water->fluid.density;
}

template <typename Group>
MixtureNodes masses(const Grid& grid, std::size_t n, Group group, double density, double empty,
                    double without_water) {
  const Lanes solid = group.load(&grid.mass[n]);
  const Lanes water = group.load(&grid.water_mass[n]);
  return {solid,
          water,
          density * group.load(&grid.wet_volume[n]),
          group.load(&grid.resistance[n]),
          solid > empty,
          water > without_water};
}

/// n = m_f/(rho_f V), 0 where there is no water.
Lanes porosity(const MixtureNodes& nodes) {
  return nodes.water_mass * inverse(nodes.full_water, nodes.has_water);
}

/// Nodes that water may pass: it flows there, and no soil touches them that lets none enter, not even by a
/// share of 1e-9.
LaneMask lets_pass(const MixtureNodes& nodes, double density) {
  return nodes.has_water & (density * nodes.resistance < 1e-9 * sealed * nodes.full_water);
}

} // namespace

ExactSums<1> water_velocities(Ground& ground, std::span<const NodeRange> rows) {
  Grid& grid = ground.grid;
  const double without = empty_water(ground);
  return sum_over_rows<1>(ground, rows, [&](const NodeRange& nodes) {
    Lanes kinetic{};
    by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
      const Lanes m = group.load(&grid.water_mass[n]);
      const LaneMask wet = m > without;
      const Lanes per_mass = inverse(m, wet);
      const auto velocity = [&](const NodeField& momentum, const NodeField& of_soil, NodeField& to) {
        const Lanes v = choose(wet, group.load(&momentum[n]) * per_mass, group.load(&of_soil[n]));
        group.store(&to[n], v);
        kinetic += choose(wet, 0.5 * m * v * v, Lanes{});
      };
      velocity(grid.water_momentum_x, grid.vx_before, grid.wx_before);
      velocity(grid.water_momentum_y, grid.vy_before, grid.wy_before);
    });
    return std::array{sum(kinetic)};
  });
}

ExactSums<4> update_mixture(Ground& ground, double dt, std::span<const NodeRange> rows) {
  Grid& grid = ground.grid;
  const double empty = empty_mass(ground);
  const double without = empty_water(ground);
  const double density = density_of_water(ground);
  const double gravity = ground.spec.gravity;
  return sum_over_rows<4>(ground, rows, [&](const NodeRange& nodes) {
    Lanes kinetic{};
    Lanes weight_work{}; // over the step, downwards
    Lanes relief{};
    Lanes drag{};
    by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
      const MixtureNodes m = masses(grid, n, group, density, empty, without);
      const Lanes water = choose(m.has_water, m.water_mass, Lanes{});
      const Lanes pores = porosity(m);
      // One component; returns the mean velocity of the grains over the step.
      const auto kick = [&](const NodeField& force, const NodeField& dashpot, const NodeField& pull,
                            const NodeField& open, const NodeField& v_before, const NodeField& w_before,
                            NodeField& acceleration, NodeField& v_after, NodeField& w_after) {
        const Lanes c = group.load(&dashpot[n]);
        const Lanes v = group.load(&v_before[n]);
        const Lanes vf = group.load(&w_before[n]);
        const Lanes f = group.load(&pull[n]);
        const MixtureKick a = kick_mixture(m, group.load(&force[n]), c, f, vf - v, group.load(&open[n]), dt);
        const Lanes u = v + dt * a.solid;
        const Lanes uf = choose(m.has_water, vf + dt * a.water, u);
        const Lanes mid = 0.5 * (v + u);
        group.store(&acceleration[n], a.solid);
        group.store(&v_after[n], u);
        group.store(&w_after[n], uf);
        kinetic += 0.5 * (m.solid_mass * u * u + water * uf * uf);
        relief -= c * a.mixture * mid;
        drag += (pores * f - water * a.water) * (0.5 * (vf + uf) - mid);
        return mid;
      };
      kick(grid.force_x, grid.dashpot_x, grid.water_force_x, grid.open_x, grid.vx_before, grid.wx_before,
           grid.ax, grid.vx_after, grid.wx_after);
      const Lanes mid = kick(grid.force_y, grid.dashpot_y, grid.water_force_y, grid.open_y, grid.vy_before,
                             grid.wy_before, grid.ay, grid.vy_after, grid.wy_after);
      weight_work -= gravity * m.solid_mass * mid;
    });
    return std::array{sum(kinetic), dt * sum(weight_work), 0.5 * dt * dt * sum(relief), dt * sum(drag)};
  });
}

void find_flux(Ground& ground, std::span<const NodeRange> rows) {
  Grid& grid = ground.grid;
  const double empty = empty_mass(ground);
  const double without = empty_water(ground);
  const double density = density_of_water(ground);
  ground.workers.run(rows.size(), [&](std::size_t row) {
    by_fours(rows[row].begin, rows[row].end, [&](std::size_t n, auto group) {
      const Lanes pores = porosity(masses(grid, n, group, density, empty, without));
      const auto flux = [&](const NodeField& v, const NodeField& w, NodeField& to) {
        const Lanes of_soil = group.load(&v[n]);
        group.store(&to[n], of_soil + pores * (group.load(&w[n]) - of_soil));
      };
      flux(grid.vx_after, grid.wx_after, grid.flux_x);
      flux(grid.vy_after, grid.wy_after, grid.flux_y);
    });
  });
}

ExactSums<1> remap_flux(Ground& ground, std::span<const NodeRange> rows) {
  Grid& grid = ground.grid;
  const double empty = empty_mass(ground);
  const double without = empty_water(ground);
  const double density = density_of_water(ground);
  return sum_over_rows<1>(ground, rows, [&](const NodeRange& nodes) {
    Lanes power{};
    by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
      const MixtureNodes m = masses(grid, n, group, density, empty, without);
      const Lanes pores = porosity(m);
      const Lanes per_mass = inverse(m.water_mass, m.has_water);
      const LaneMask passes = lets_pass(m, density);
      const auto remap = [&](const NodeField& momentum, const NodeField& open, const NodeField& pull,
                             const NodeField& v_strain, const NodeField& v_after, const NodeField& w_after,
                             NodeField& flux) {
        const Lanes u = group.load(&v_strain[n]);
        const Lanes relative =
            choose(passes, group.load(&open[n]) * (group.load(&momentum[n]) * per_mass - u), Lanes{});
        group.store(&flux[n], u + pores * relative);
        const Lanes after = group.load(&w_after[n]) - group.load(&v_after[n]);
        power += pores * group.load(&pull[n]) * (after - relative);
      };
      remap(grid.water_momentum_x, grid.open_x, grid.water_force_x, grid.vx_strain, grid.vx_after,
            grid.wx_after, grid.flux_x);
      remap(grid.water_momentum_y, grid.open_y, grid.water_force_y, grid.vy_strain, grid.vy_after,
            grid.wy_after, grid.flux_y);
    });
    return std::array{sum(power)};
  });
}

namespace {

/// Factors of velocities that a power is taken on.
struct OfVelocity {
  double factor;
  const NodeField &x, &y;
};

/// Sum of (buoyancy e_y + seepage force) . (a + b), W/m
ExactSums<1> power_of_lift(Ground& ground, std::span<const NodeRange> rows, const OfVelocity& a,
                           const OfVelocity& b) {
  const Grid& grid = ground.grid;
  const bool seeps = ground.has_seepage();
  return sum_over_rows<1>(ground, rows, [&](const NodeRange& nodes) {
    Lanes power{};
    by_fours(nodes.begin, nodes.end, [&](std::size_t n, auto group) {
      const auto of = [&](const NodeField& va, const NodeField& vb) {
        return a.factor * group.load(&va[n]) + b.factor * group.load(&vb[n]);
      };
      power += group.load(&grid.buoyancy[n]) * of(a.y, b.y);
      if (seeps)
        power +=
            group.load(&grid.seepage_x[n]) * of(a.x, b.x) + group.load(&grid.seepage_y[n]) * of(a.y, b.y);
    });
    return std::array{sum(power)};
  });
}

} // namespace

ExactSums<1> buoyancy_power(Ground& ground, std::span<const NodeRange> rows) {
  const Grid& grid = ground.grid;
  return power_of_lift(ground, rows, {0.5, grid.vx_before, grid.vy_before},
                       {0.5, grid.vx_after, grid.vy_after});
}

ExactSums<1> buoyancy_remap_power(Ground& ground, std::span<const NodeRange> rows) {
  const Grid& grid = ground.grid;
  return power_of_lift(ground, rows, {1.0, grid.vx_after, grid.vy_after},
                       {-1.0, grid.vx_strain, grid.vy_strain});
}

} // namespace tremolo::mpm_domain
