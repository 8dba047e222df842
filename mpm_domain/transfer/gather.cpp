#include "mpm_domain/transfer/gather.hpp"

#include "mpm_domain/grid/box_average.hpp"
#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/strain/cell_dilatation.hpp"
#include "mpm_domain/strain/strain_update.hpp"
#include "mpm_domain/transfer/samples.hpp"
#include "mpm_domain/transfer/sharp_transfer.hpp"
#include "mpm_domain/transfer/wide_squares.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

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
[[gnu::always_inline]] inline void take_cross(Particles& p, std::size_t k, Group group, const Samples& q) {
  group.store(&p.cross_x[k], q.cross.x);
  group.store(&p.cross_y[k], q.cross.y);
}

template <typename Group>
[[gnu::always_inline]] inline void take_change(Particles& p, std::size_t k, Group group, const Samples& q) {
  group.store(&p.vx[k], group.load(&p.vx[k]) + q.v_after.x - q.v_before.x);
  group.store(&p.vy[k], group.load(&p.vy[k]) + q.v_after.y - q.v_before.y);
}

template <GatherParts parts, bool affine>
constexpr Wanted wanted_by{.v_before = parts.velocity && !affine,
                           .v_after = parts.velocity || parts.position,
                           .gradient = parts.strain,
                           .remapped = parts.remapped,
                           .affine = (parts.velocity && affine),
                           .bilinear = (parts.velocity && parts.sharp)};

/// @param sample_at  (k, group, x, y) -> Samples of a group of particles from k on, at x and y
/// @param waiting    takes the strains until the means of cells are known; null: the law sees them at once
template <GatherParts parts, bool affine, bool boxes_follow, typename SampleAt>
GatherSums gather_range(Particles& p, const ParticleRange& range, double dt, WaitingRange* waiting,
                        const SampleAt& sample_at) {
  LaneSums sums;
  Increments inc;
  for (std::size_t first = range.begin; first < range.end; first += strain_chunk_size) {
    const std::size_t count = std::min(strain_chunk_size, range.end - first);
    if (parts.strain && waiting != nullptr)
      waiting->find_cells(p, first, count);
    by_fours(
        0, count, [&](std::size_t c, auto group) __attribute__((always_inline)) {
          const std::size_t k = first + c;
          const Lanes x = group.load(&p.x[k]);
          const Lanes y = group.load(&p.y[k]);
          const Samples q = sample_at(k, group, x, y);
          if constexpr (parts.velocity) {
            if constexpr (affine)
              take_affine(p, k, group, q);
            else
              take_change(p, k, group, q);
            if constexpr (parts.sharp)
              take_cross(p, k, group, q);
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
      if (waiting != nullptr)
        waiting->hold(p, first, count, inc);
      else
        strain_chunk(p, first, count, inc, inc, dt, sums);
    }
  }
  return sums.collected();
}

/// Gathers for the particles of a set that lie in a tile and touch its lattice alone.
template <GatherParts parts, bool affine, typename Boxes>
GatherSums gather_tile(Ground& ground, Particles& p, int clock, std::size_t tile, double dt,
                       WaitingRange* waiting) {
  constexpr Wanted wanted = wanted_by<parts, affine>;
  const VelocityFields velocities = of_soil(ground.grid);
  const Lattice& lattice = ground.tiles.lattice(ground.tiles.level_of(tile));
  const Axis x_axis(lattice.x0, lattice.h);
  const Axis y_axis(lattice.y0, lattice.h);
  const auto boxes = [&] {
    if constexpr (std::is_same_v<Boxes, WideSquares>)
      return WideSquares(p, lattice, ground.grid);
    else
      return Boxes(p, lattice, x_axis);
  }();
  const auto sample_at = [&](std::size_t k, auto group, const Lanes& x, const Lanes& y)
      __attribute__((always_inline)) {
    return sample<wanted, Boxes::rows>(velocities, lattice, x, y, group.count, x_axis, y_axis,
                                       boxes.of(k, group));
  };
  return gather_range<parts, affine, Boxes::follow>(p, p.in_block(ground.block(clock, tile)), dt, waiting,
                                                    sample_at);
}

/// Gathers for the particles of a set in a tile that touch several lattices.
template <GatherParts parts, bool affine, bool boxes_follow>
GatherSums gather_across(Ground& ground, const AcrossTile& tile, double dt, WaitingRange* waiting) {
  constexpr Wanted wanted = wanted_by<parts, affine>;
  Particles& p = ground.sets[tile.set];
  const VelocityFields velocities = of_soil(ground.grid);
  return gather_range<parts, affine, boxes_follow>(
      p, {tile.weights.first(), tile.weights.end()}, dt, waiting,
      [&](std::size_t k, auto group, const Lanes&, const Lanes&) {
        return sample_across<wanted>(velocities, tile.weights, ground.basis_cells, p, k, group.count);
      });
}

template <GatherParts parts, bool affine>
GatherSums gather_set(Ground& ground, Particles& p, int clock, std::size_t tile, double dt,
                      WaitingRange* waiting) {
  if constexpr (parts.sharp) {
    using Boxes = std::conditional_t<parts.strain, WideSquares, OneSquare>;
    return gather_tile<parts, true, Boxes>(ground, p, clock, tile, dt, waiting);
  }
  return p.has_own_boxes() ? gather_tile<parts, affine, OwnRectangles>(ground, p, clock, tile, dt, waiting)
                           : gather_tile<parts, affine, OneSquare>(ground, p, clock, tile, dt, waiting);
}

template <GatherParts parts, bool affine>
GatherSums gather_set(Ground& ground, const AcrossTile& tile, double dt, WaitingRange* waiting) {
  return ground.sets[tile.set].has_own_boxes()
             ? gather_across<parts, affine, true>(ground, tile, dt, waiting)
             : gather_across<parts, affine, false>(ground, tile, dt, waiting);
}

/// Gathers for the particles of all sets in a tile that touch one lattice.
/// @param window  takes the sums over cells of sets whose law sees the mean dilatation
template <GatherParts parts>
GatherSums gather_filled(Ground& ground, int clock, std::size_t tile, double dt, double* window) {
  GatherSums sums;
  for (std::size_t s = 0; s < ground.sets.size(); ++s) {
    Particles& p = ground.sets[s];
    std::optional<WaitingRange> waits;
    if (parts.strain && p.traits.cell_dilatation)
      waits.emplace(ground.waiting_strains[s], ground.tiles, tile, window);
    WaitingRange* const waiting = waits ? &*waits : nullptr;
    sums += p.traits.affine ? gather_set<parts, true>(ground, p, clock, tile, dt, waiting)
                            : gather_set<parts, false>(ground, p, clock, tile, dt, waiting);
  }
  return sums;
}

template <GatherParts parts>
GatherSums gather_across_tile(Ground& ground, const AcrossTile& tile, double dt) {
  const Particles& p = ground.sets[tile.set];
  std::optional<WaitingRange> waits;
  if (parts.strain && p.traits.cell_dilatation)
    waits.emplace(ground.waiting_strains[tile.set], *ground.mesh);
  WaitingRange* const waiting = waits ? &*waits : nullptr;
  return p.traits.affine ? gather_set<parts, true>(ground, tile, dt, waiting)
                         : gather_set<parts, false>(ground, tile, dt, waiting);
}

template <GatherParts parts>
GatherTotals gather_tiles(Ground& ground, double dt, int clock) {
  ClockTiles& tiles = ground.clock_tiles[static_cast<std::size_t>(clock)];
  const std::span<const std::size_t> filled = tiles.sums.filled();
  std::vector<GatherSums> sums(filled.size() + tiles.across.size());
  const auto across = [&](std::size_t n) {
    const TileTimer timer(ground.tile_times(), tiles.across[n].tile);
    sums[filled.size() + n] = gather_across_tile<parts>(ground, tiles.across[n], dt);
  };
  if (parts.strain && some_wait(ground)) {
    clear_strains(ground);
    tiles.sums.add_to(ground.grid, cell_sums, ground.tiles, ground.workers, ground.windows,
                      [&](std::size_t n, double* window) {
                        const TileTimer timer(ground.tile_times(), filled[n]);
                        sums[n] = gather_filled<parts>(ground, clock, filled[n], dt, window);
                        const NodeBlock position = ground.tiles.window(filled[n]);
                        return RowRange{position.row, position.end_row()};
                      });
    ground.workers.run(tiles.across.size(), across);
    const std::vector<GatherSums> by_cells = strain_by_cells(ground, clock, dt);
    sums.insert(sums.end(), by_cells.begin(), by_cells.end());
  } else {
    ground.workers.run(sums.size(), [&](std::size_t task) {
      if (task >= filled.size())
        return across(task - filled.size());
      const TileTimer timer(ground.tile_times(), filled[task]);
      sums[task] = gather_filled<parts>(ground, clock, filled[task], dt, nullptr);
    });
  }
  constexpr bool adds_up = parts.strain || parts.position || parts.drift;
  GatherTotals totals;
  if (adds_up)
    for (const GatherSums& sum : sums)
      totals.add(sum);
  return totals;
}

constexpr GatherParts all_parts{.velocity = true, .position = true, .strain = true};
constexpr GatherParts velocity_part{.velocity = true};
constexpr GatherParts rest_parts{.position = true, .strain = true, .remapped = true};
constexpr GatherParts drift_parts{.drift = true, .strain = true, .remapped = true};
constexpr GatherParts strain_part{.strain = true};
constexpr GatherParts sharp_velocity_part{.velocity = true, .sharp = true};
constexpr GatherParts sharp_drift_parts{.drift = true, .strain = true, .remapped = true, .sharp = true};
constexpr GatherParts sharp_strain_part{.strain = true, .remapped = true, .sharp = true};

} // namespace

GatherTotals gather(Ground& ground, double dt, GatherParts parts, int clock) {
  if (parts == all_parts)
    return gather_tiles<all_parts>(ground, dt, clock);
  if (parts == velocity_part)
    return gather_tiles<velocity_part>(ground, dt, clock);
  if (parts == rest_parts)
    return gather_tiles<rest_parts>(ground, dt, clock);
  if (parts == drift_parts)
    return gather_tiles<drift_parts>(ground, dt, clock);
  if (parts == strain_part)
    return gather_tiles<strain_part>(ground, dt, clock);
  if (parts == sharp_velocity_part)
    return gather_tiles<sharp_velocity_part>(ground, dt, clock);
  if (parts == sharp_drift_parts)
    return gather_tiles<sharp_drift_parts>(ground, dt, clock);
  if (parts == sharp_strain_part)
    return gather_tiles<sharp_strain_part>(ground, dt, clock);
  throw std::logic_error("gather: no step asks for this combination of parts");
}

GatherTotals gather(Ground& ground, double dt, GatherParts parts) {
  GatherTotals total;
  for (int clock = 0; clock < ground.clocks.count(); ++clock)
    total += gather(ground, dt, parts, clock);
  return total;
}

Vector particle_velocity(const Ground& ground, const Particles& particles, std::size_t k) {
  return ground.is_sharp() ? sharp_reading(ground, particles, k, ground.grid.vx_after, ground.grid.vy_after)
                           : Vector{particles.vx[k], particles.vy[k]};
}

Vector particle_acceleration(const Ground& ground, const Particles& particles, std::size_t k) {
  if (ground.is_sharp())
    return sharp_reading(ground, particles, k, ground.grid.ax, ground.grid.ay);
  Vector a;
  const auto add = [&](std::size_t n, double s) {
    a.x += s * ground.grid.ax[n];
    a.y += s * ground.grid.ay[n];
  };
  if (ground.mesh && !particles.body) {
    std::vector<BoxWeight> weights;
    box_average(*ground.mesh, box_of(particles, k), weights);
    for (const BoxWeight& w : weights)
      add(w.node, w.s);
    return a;
  }
  const Vector half = half_sides(particles, k);
  const Lattice& lattice = particles.body ? ground.bodies[*particles.body].lattice : ground.grid;
  const Weights wx = cell_weights(particles.x[k], {lattice.x0, lattice.h}, half.x);
  const Weights wy = cell_weights(particles.y[k], {lattice.y0, lattice.h}, half.y);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      add(lattice.index(wx.base + i, wy.base + j), wx.s[i] * wy.s[j]);
  return a;
}

} // namespace tremolo::mpm_domain
