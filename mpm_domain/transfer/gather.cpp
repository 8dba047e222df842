#include "mpm_domain/transfer/gather.hpp"

#include "materials/law/law.hpp"
#include "mpm_domain/grid/box_average.hpp"
#include "mpm_domain/transfer/samples.hpp"
#include "mpm_domain/transfer/viscous_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Particles whose increments are held at a time between the grid and the law.
constexpr std::size_t chunk = 128;

using ChunkField = std::array<double, chunk>;

struct Increments {
  ChunkField exx, eyy, gxy, wxy;
  ChunkField plastic; ///< plastic work per volume
};

template <typename Group>
[[gnu::always_inline]] inline void take_affine(Particles& p, std::size_t k, Group group, const Samples& q) {
  group.store(&p.vx[k], q.v_after.x);
  group.store(&p.vy[k], q.v_after.y);
  group.store(&p.bxx[k], q.bxx);
  group.store(&p.byx[k], q.byx);
  group.store(&p.bxy[k], q.bxy);
  group.store(&p.byy[k], q.byy);
}

template <typename Group>
[[gnu::always_inline]] inline void take_change(Particles& p, std::size_t k, Group group, const Samples& q) {
  group.store(&p.vx[k], group.load(&p.vx[k]) + q.v_after.x - q.v_before.x);
  group.store(&p.vy[k], group.load(&p.vy[k]) + q.v_after.y - q.v_before.y);
}

/// sigma : de of the increments from `c` on, J/m3
template <typename Group>
[[gnu::always_inline]] inline Lanes work_density(const Particles& p, std::size_t k, const Increments& inc,
                                                 std::size_t c, Group group) {
  return group.load(&p.sxx[k]) * load(&inc.exx[c]) + group.load(&p.syy[k]) * load(&inc.eyy[c]) +
         group.load(&p.sxy[k]) * load(&inc.gxy[c]);
}

/// Sums of a range, four particles side by side.
struct LaneSums {
  Lanes total{};   ///< work of the stresses, J/m
  Lanes plastic{}; ///< of it on plastic strain
  Lanes max_speed2{};
  double viscous = 0.0; ///< work of the viscous stresses, J/m

  GatherSums collected() const {
    const Lanes& m = max_speed2;
    return {sum(total) - sum(plastic), sum(plastic), viscous,
            std::sqrt(std::max(std::max(m[0], m[1]), std::max(m[2], m[3])))};
  }
};

/// Strain and rotation increments about the middle of the step (Hughes and Winget 1980), A (I + A/2)^-1 with
/// A = dt grad u, here to its second order A - A^2/2: taken about its beginning, a turn by theta would be
/// read as a contraction by theta^2/2. And half of the work: that of the stress before the update.
template <typename Group>
[[gnu::always_inline]] inline void take_strain(const Particles& p, std::size_t k, Group group,
                                               const DisplacementGradient<Lanes>& a, std::size_t c,
                                               Increments& inc, LaneSums& sums) {
  const auto& [xx, xy, yx, yy] = a;
  const Lanes across = 0.5 * xy * yx;
  const Lanes half_rest = 1.0 - 0.5 * (xx + yy);
  store(&inc.exx[c], xx - 0.5 * xx * xx - across);
  store(&inc.eyy[c], yy - 0.5 * yy * yy - across);
  store(&inc.gxy[c], half_rest * (xy + yx));
  store(&inc.wxy[c], 0.5 * half_rest * (yx - xy));
  store(&inc.plastic[c], Lanes{});
  sums.total += 0.5 * group.load(&p.volume[k]) * work_density(p, k, inc, c, group);
}

/// The boxes of a group follow the soil.
template <typename Group>
[[gnu::always_inline]] inline void deform_boxes(Particles& p, std::size_t k, Group group,
                                                const DisplacementGradient<Lanes>& a) {
  const BoxMoments<Lanes> box =
      deformed<Lanes>({group.load(&p.box_xx[k]), group.load(&p.box_xy[k]), group.load(&p.box_yy[k])}, a);
  group.store(&p.box_xx[k], box.xx);
  group.store(&p.box_xy[k], box.xy);
  group.store(&p.box_yy[k], box.yy);
}

/// Stress and state of a chunk by its law, then the other half of the work, and the volumes.
void strain_chunk(Particles& p, std::size_t begin, std::size_t count, Increments& inc, LaneSums& sums) {
  materials::Points points = p.points(begin, count);
  points.plastic_work = inc.plastic.data();
  points.dexx = inc.exx.data();
  points.deyy = inc.eyy.data();
  points.dgxy = inc.gxy.data();
  points.dwxy = inc.wxy.data();
  materials::update(p.law, points);
  by_fours(0, count, [&](std::size_t c, auto group) {
    const std::size_t k = begin + c;
    const Lanes before = group.load(&p.volume[k]);
    const Lanes dilation = load(&inc.exx[c]) + load(&inc.eyy[c]);
    const Lanes volume = before * growth(dilation);
    sums.total += 0.5 * volume * work_density(p, k, inc, c, group);
    sums.plastic += 0.5 * (before + volume) * load(&inc.plastic[c]);
    group.store(&p.volume[k], volume);
  });
}

template <GatherParts parts, bool affine>
constexpr Wanted wanted_by{.v_before = parts.velocity && !affine,
                           .v_after = parts.velocity || parts.position,
                           .gradient = parts.strain,
                           .remapped = parts.remapped,
                           .affine = (parts.velocity && affine)};

/// @param sample_at  (k, group, x, y) -> what a group of particles from k on, at x and y, reads off the grid
template <GatherParts parts, bool affine, bool boxes_follow, typename SampleAt>
GatherSums gather_range(Particles& p, const ParticleRange& range, double dt, const SampleAt& sample_at) {
  LaneSums sums;
  Increments inc;
  for (std::size_t first = range.begin; first < range.end; first += chunk) {
    const std::size_t count = std::min(chunk, range.end - first);
    by_fours(0, count, [&](std::size_t c, auto group) {
      const std::size_t k = first + c;
      const Lanes x = group.load(&p.x[k]);
      const Lanes y = group.load(&p.y[k]);
      const Samples q = sample_at(k, group, x, y);
      if constexpr (parts.velocity) {
        if constexpr (affine)
          take_affine(p, k, group, q);
        else
          take_change(p, k, group, q);
      }
      if constexpr (parts.strain) {
        const DisplacementGradient<Lanes> a{dt * q.vx_x, dt * q.vx_y, dt * q.vy_x, dt * q.vy_y};
        take_strain(p, k, group, a, c, inc, sums);
        if constexpr (boxes_follow)
          deform_boxes(p, k, group, a);
      }
      if constexpr (parts.position || parts.drift) {
        const Vectors v = parts.drift ? Vectors{group.load(&p.vx[k]), group.load(&p.vy[k])} : q.v_after;
        group.store(&p.x[k], x + dt * v.x);
        group.store(&p.y[k], y + dt * v.y);
        sums.max_speed2 = larger(v.x * v.x + v.y * v.y, sums.max_speed2);
      }
    });
    if constexpr (parts.strain) {
      if (p.traits.damped)
        sums.viscous += damp(p, {first, first + count}, {inc.exx.data(), inc.eyy.data(), inc.gxy.data()}, dt);
      strain_chunk(p, first, count, inc, sums);
    }
  }
  return sums.collected();
}

/// The particles of a soil in a tile.
template <GatherParts parts, bool affine, typename Boxes>
GatherSums gather_tile(Domain& domain, Particles& p, int clock, std::size_t tile, double dt) {
  constexpr Wanted wanted = wanted_by<parts, affine>;
  const Grid& grid = domain.grid;
  const Lattice& lattice = domain.tiles.lattice(domain.tiles.level_of(tile));
  const Axis x_axis(lattice.x0, lattice.h);
  const Axis y_axis(lattice.y0, lattice.h);
  const Boxes boxes(p, lattice, x_axis);
  return gather_range<parts, affine, Boxes::follow>(
      p, p.in_block(domain.block(clock, tile)),
      dt, [&](std::size_t k, auto group, const Lanes& x, const Lanes& y) __attribute__((always_inline)) {
        return sample<wanted, Boxes::rows>(grid, lattice, x, y, group.count, x_axis, y_axis,
                                           boxes.of(k, group));
      });
}

/// In a tile across several lattices.
template <GatherParts parts, bool affine, bool boxes_follow>
GatherSums gather_across(Domain& domain, const AcrossTile& tile, double dt) {
  constexpr Wanted wanted = wanted_by<parts, affine>;
  Particles& p = domain.sets[tile.set];
  const Grid& grid = domain.grid;
  return gather_range<parts, affine, boxes_follow>(
      p, {tile.weights.first(), tile.weights.end()}, dt,
      [&](std::size_t k, auto group, const Lanes&, const Lanes&) {
        return sample_across<wanted>(grid, tile.weights, domain.basis_cells, p, k, group.count);
      });
}

template <GatherParts parts, bool affine>
GatherSums gather_set(Domain& domain, Particles& p, int clock, std::size_t tile, double dt) {
  return p.has_own_boxes() ? gather_tile<parts, affine, OwnRectangles>(domain, p, clock, tile, dt)
                           : gather_tile<parts, affine, OneSquare>(domain, p, clock, tile, dt);
}

template <GatherParts parts, bool affine>
GatherSums gather_set(Domain& domain, const AcrossTile& tile, double dt) {
  return domain.sets[tile.set].has_own_boxes() ? gather_across<parts, affine, true>(domain, tile, dt)
                                               : gather_across<parts, affine, false>(domain, tile, dt);
}

template <GatherParts parts>
GatherSums gather_tiles(Domain& domain, double dt, int clock) {
  const ClockTiles& tiles = domain.clock_tiles[static_cast<std::size_t>(clock)];
  const std::span<const std::size_t> filled = tiles.sums.filled();
  std::vector<GatherSums> sums(filled.size() + tiles.across.size());
  domain.workers.run(sums.size(), [&](std::size_t task) {
    if (task < filled.size())
      for (Particles& p : domain.sets)
        sums[task] += p.traits.affine ? gather_set<parts, true>(domain, p, clock, filled[task], dt)
                                      : gather_set<parts, false>(domain, p, clock, filled[task], dt);
    else {
      const AcrossTile& tile = tiles.across[task - filled.size()];
      sums[task] = domain.sets[tile.set].traits.affine ? gather_set<parts, true>(domain, tile, dt)
                                                       : gather_set<parts, false>(domain, tile, dt);
    }
  });
  GatherSums total;
  for (const GatherSums& sum : sums)
    total += sum;
  return total;
}

constexpr GatherParts all_parts{.velocity = true, .position = true, .strain = true};
constexpr GatherParts velocity_part{.velocity = true};
constexpr GatherParts rest_parts{.position = true, .strain = true, .remapped = true};
constexpr GatherParts drift_parts{.drift = true, .strain = true, .remapped = true};
constexpr GatherParts strain_part{.strain = true};

} // namespace

GatherSums gather(Domain& domain, double dt, GatherParts parts, int clock) {
  if (parts == all_parts)
    return gather_tiles<all_parts>(domain, dt, clock);
  if (parts == velocity_part)
    return gather_tiles<velocity_part>(domain, dt, clock);
  if (parts == rest_parts)
    return gather_tiles<rest_parts>(domain, dt, clock);
  if (parts == drift_parts)
    return gather_tiles<drift_parts>(domain, dt, clock);
  if (parts == strain_part)
    return gather_tiles<strain_part>(domain, dt, clock);
  throw std::logic_error("gather: no step asks for this combination of parts");
}

GatherSums gather(Domain& domain, double dt, GatherParts parts) {
  GatherSums total;
  for (int clock = 0; clock < domain.clocks.count(); ++clock)
    total += gather(domain, dt, parts, clock);
  return total;
}

Vector particle_acceleration(const Domain& domain, const Particles& particles, std::size_t k) {
  Vector a;
  const auto add = [&](std::size_t n, double s) {
    a.x += s * domain.grid.ax[n];
    a.y += s * domain.grid.ay[n];
  };
  if (domain.mesh) {
    std::vector<BoxWeight> weights;
    box_average(*domain.mesh, box_of(particles, k), weights);
    for (const BoxWeight& w : weights)
      add(w.node, w.s);
    return a;
  }
  const Vector half = half_sides(particles, k);
  const Weights wx = cell_weights(particles.x[k], domain.x_axis(), half.x);
  const Weights wy = cell_weights(particles.y[k], domain.y_axis(), half.y);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      add(domain.grid.index(wx.base + i, wy.base + j), wx.s[i] * wy.s[j]);
  return a;
}

} // namespace tremolo::mpm_domain
