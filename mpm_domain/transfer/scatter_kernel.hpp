#pragma once

// Sums of particles at nodes, chunk by chunk: on one lattice with stencils, in the window of their tile;
// across several lattices four nodes at a time.

#include "mpm_domain/ground.hpp"
#include "mpm_domain/transfer/phases.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <vector>

namespace tremolo::mpm_domain {

/// The part of the particles' motion that a pass scatters.
enum class Motion { none, momentum, mass_and_momentum };

template <std::size_t rows>
using Rows = std::array<Lanes, rows>;

template <std::size_t rows>
[[gnu::always_inline]] inline void add_rows(double* nodes, const Rows<rows>& sums) {
  for (std::size_t j = 0; j < rows; ++j, nodes += window_columns)
    store(nodes, load(nodes) + sums[j]);
}

template <std::size_t rows>
[[gnu::always_inline]] inline void add_rows(double* nodes, double factor, const Rows<rows>& sums) {
  for (std::size_t j = 0; j < rows; ++j, nodes += window_columns)
    store(nodes, load(nodes) + factor * sums[j]);
}

/// The first particle of a cell begins the sums.
template <bool first>
[[gnu::always_inline]] inline void add_to_row(Lanes& sum, const Lanes& value) {
  if constexpr (first)
    sum = value;
  else
    sum += value;
}

/// Sums of the particles of one cell for the nodes that they share, in rows of four. The sums stay in
/// registers while the particles are read and are written to the tile's window once. Motion and force are
/// summed up one after the other, since the registers do not hold both. Numbers of water that go with the
/// mass or the volume of a particle take the products with S that momentum and force need anyway.
/// @tparam wet  whether the soil is under water: its buoyancy is a share of its mass
template <Motion motion, bool wet, std::size_t rows>
struct MotionSums {
  static_assert(!wet || motion == Motion::mass_and_momentum);
  static constexpr bool in_cells = false;
  Rows<rows> mass, momentum_x, momentum_y; ///< not set until the first particle

  /// S m and S m (v + C (x_i - x)), C = B D^-1, and where the velocity is bilinear, S m c (x_i - x)(y_i - y)
  /// with c that sum over the particle D^-1 in both directions. Lanes run along x: for each row only the
  /// factor of y remains.
  template <Around around, bool first>
  [[gnu::always_inline]] void add(const Arrays& a, const ChunkWeights<rows>& w, std::size_t c, double h) {
    const Lanes m = a.mass[c] * w.xs[c];
    Lanes vx = all(a.vx[c]);
    Lanes vy = all(a.vy[c]);
    Lanes row_x{}; // increment of momentum from one row to the next
    Lanes row_y{};
    if constexpr (around != Around::uniform) {
      constexpr Lanes node = {-1.0, 0.0, 1.0, 2.0};
      const Lanes dx = h * (node - w.xi[c]);
      const double dy = -h * w.eta[c];
      const double cxy = a.bxy[c] * w.per_y[c];
      const double cyy = a.byy[c] * w.per_y[c];
      if constexpr (around == Around::affine) {
        vx += a.bxx[c] * w.per_x[c] * dx + cxy * dy;
        vy += a.byx[c] * w.per_x[c] * dx + cyy * dy;
        row_x = cxy * h * m;
        row_y = cyy * h * m;
      } else {
        const Lanes along = w.per_x[c] * dx;
        const Lanes hm = h * m;
        const Lanes up_x = cxy + (a.cross_x[c] * w.per_y[c]) * along; // dv/dy
        const Lanes up_y = cyy + (a.cross_y[c] * w.per_y[c]) * along;
        vx += a.bxx[c] * along + up_x * dy;
        vy += a.byx[c] * along + up_y * dy;
        row_x = up_x * hm;
        row_y = up_y * hm;
      }
    }
    Lanes px = m * vx;
    Lanes py = m * vy;
    for (std::size_t j = 0; j < rows; ++j) {
      const double s = w.ys[j][c];
      if constexpr (motion == Motion::mass_and_momentum)
        add_to_row<first>(mass[j], s * m);
      add_to_row<first>(momentum_x[j], s * px);
      add_to_row<first>(momentum_y[j], s * py);
      if constexpr (around != Around::uniform) {
        px += row_x;
        py += row_y;
      }
    }
  }

  [[gnu::always_inline]] void add_to(const Arrays& a, std::ptrdiff_t first) const {
    if constexpr (motion == Motion::mass_and_momentum)
      add_rows(a.of(Sum::mass) + first, mass);
    if constexpr (wet)
      add_rows(a.of(Sum::buoyancy) + first, a.buoyancy, mass);
    add_rows(a.of(Sum::momentum_x) + first, momentum_x);
    add_rows(a.of(Sum::momentum_y) + first, momentum_y);
  }
};

/// @tparam wet  whether the pore volumes of soil are summed up too. Water that flows sums up the soil's
/// volume
template <Pull pull, bool wet, std::size_t rows>
struct ForceSums {
  static constexpr bool in_cells = wet && pull == Pull::stress_and_weight;
  Rows<rows> force_x, force_y;
  Rows<rows> volume;

  /// S m g - V sigma grad S
  template <bool first>
  [[gnu::always_inline]] void add(const Arrays& a, const ChunkWeights<rows>& w, std::size_t c,
                                  const Lanes& gravity) {
    const Lanes vs = a.volume[c] * w.xs[c];
    const Lanes vg = a.volume[c] * w.xg[c];
    if constexpr (pull == Pull::pressure) {
      const Lanes along = a.sxx[c] * vg;
      const Lanes up = a.syy[c] * vs;
      for (std::size_t j = 0; j < rows; ++j) {
        add_to_row<first>(force_x[j], -(w.ys[j][c] * along));
        add_to_row<first>(force_y[j], -(w.yg[j][c] * up));
        add_to_row<first>(volume[j], w.ys[j][c] * vs);
      }
      return;
    }
    const Lanes ms = a.mass[c] * w.xs[c];
    const Lanes pores = vs - a.grains_per_mass * ms;
    const Lanes fx_s = a.sxx[c] * vg;
    const Lanes fx_g = a.sxy[c] * vs;
    const Lanes fy_s = a.sxy[c] * vg + gravity * ms;
    const Lanes fy_g = a.syy[c] * vs;
    for (std::size_t j = 0; j < rows; ++j) {
      const double s = w.ys[j][c];
      const double g = w.yg[j][c];
      add_to_row<first>(force_x[j], -(s * fx_s));
      add_to_row<first>(force_y[j], -(s * fy_s));
      force_x[j] -= g * fx_g;
      force_y[j] -= g * fy_g;
      if constexpr (wet)
        add_to_row<first>(volume[j], s * pores);
    }
  }

  [[gnu::always_inline]] void add_to(const Arrays& a, std::ptrdiff_t first) const {
    add_rows(a.of(Sum::force_x) + first, force_x);
    add_rows(a.of(Sum::force_y) + first, force_y);
    if constexpr (pull == Pull::pressure) {
      add_rows(a.of_water(Sum::wet_volume) + first, volume);
      add_rows(a.of_water(Sum::resistance) + first, a.resistance, volume);
    }
  }

  /// Adds the pore volumes of particles of one cell, whose run keeps what it brings.
  /// @param end  of these particles, in the chunk
  [[gnu::always_inline]] void keep(const Arrays& a, std::int32_t first, std::int32_t cell,
                                   std::size_t end) const {
    if (a.runs == nullptr)
      return;
    add_rows(a.of(Sum::pore_volume) + first, volume);
    a.runs->add(a.begin + end, first, cell, volume);
  }
};

/// Sums S q of numbers q that particles bring to nodes.
template <std::size_t count>
using ChunkScalars = std::array<std::array<double, chunk>, count>;

template <std::size_t count, std::size_t rows>
struct ScalarSums {
  static constexpr bool in_cells = false;
  std::array<Rows<rows>, count> sums;

  template <bool first>
  [[gnu::always_inline]] void add(const ChunkScalars<count>& values, const ChunkWeights<rows>& w,
                                  std::size_t c) {
    for (std::size_t f = 0; f < count; ++f) {
      const Lanes along = values[f][c] * w.xs[c];
      for (std::size_t j = 0; j < rows; ++j)
        add_to_row<first>(sums[f][j], w.ys[j][c] * along);
    }
  }

  /// @param window  where the sums of the first number stand
  [[gnu::always_inline]] void add_to(double* window, std::ptrdiff_t first) const {
    for (std::size_t f = 0; f < count; ++f)
      add_rows(window + f * window_nodes + first, sums[f]);
  }
};

/// Adds up a chunk by particles that share nodes, and where sums are those of cells, that are in one cell.
/// add(sums, c, is_first) adds the chunk's particle c.
template <typename Sums, std::size_t rows, typename To, typename Add>
[[gnu::always_inline]] inline void stream(const ChunkWeights<rows>& w, std::size_t count, const To& arrays,
                                          const Add& add) {
  for (std::size_t c = 0; c < count;) {
    const std::int32_t shared = w.first[c];
    const std::int32_t cell = Sums::in_cells ? w.cell[c] : 0;
    Sums sums;
    add(sums, c++, std::true_type{});
    while (c < count && w.first[c] == shared && (!Sums::in_cells || w.cell[c] == cell))
      add(sums, c++, std::false_type{});
    sums.add_to(arrays, shared);
    if constexpr (Sums::in_cells)
      sums.keep(arrays, shared, cell, c);
  }
}

/// Sums that pore water adds to those of the soil at the nodes.
enum class PoreWaterCoupling {
  none,
  numbers, ///< buoyancy and pore volumes
  flow,    ///< these, and water that flows with its mass, momentum, force, drag
};

/// Motion and force of one phase in a chunk.
/// @tparam wet  whether it is soil with water, whose buoyancy and pore volumes go with the forces
template <Pull pull, Motion motion, bool force, Around around, bool wet = false, std::size_t rows>
[[gnu::always_inline]] inline void scatter_phase(const Arrays& arrays, std::size_t count,
                                                 const ChunkWeights<rows>& w, double h,
                                                 const Lanes& gravity) {
  using Moving = MotionSums<motion, wet, rows>;
  using Pulling = ForceSums<pull, wet, rows>;
  if constexpr (motion != Motion::none)
    stream<Moving>(w, count, arrays, [&](Moving& sums, std::size_t c, auto is_first) {
      sums.template add<around, is_first>(arrays, w, c, h);
    });
  if constexpr (force)
    stream<Pulling>(w, count, arrays, [&](Pulling& sums, std::size_t c, auto is_first) {
      sums.template add<is_first>(arrays, w, c, gravity);
    });
}

/// Numbers in a chunk.
/// @param window    where the sums of the first number stand
/// @param values_of  (k, group) -> the numbers of a group of particles from k on
template <std::size_t count, std::size_t rows, typename ValuesOf>
[[gnu::always_inline]] inline void scatter_numbers(std::size_t k, std::size_t part,
                                                   const ChunkWeights<rows>& w, double* window,
                                                   const ValuesOf& values_of) {
  using Sums = ScalarSums<count, rows>;
  ChunkScalars<count> values;
  by_fours(0, part, [&](std::size_t c, auto group) {
    const std::array<Lanes, count> of_group = values_of(k + c, group);
    for (std::size_t f = 0; f < count; ++f)
      group.store(&values[f][c], of_group[f]);
  });
  stream<Sums>(w, part, window,
               [&](Sums& sums, std::size_t c, auto is_first) { sums.template add<is_first>(values, w, c); });
}

/// All calls in this function are inlined (`flatten`): a call would push the sums out of the registers.
/// @param runs  take the shares of pore volumes, if these are summed up
/// @returns the rows of the lattice that the particles touch
template <PoreWaterCoupling coupling, Motion motion, bool force, Around around, typename Boxes>
[[gnu::flatten]] RowRange scatter_range(const Particles& p, const ParticleRange& range,
                                        const Lattice& lattice, const NodeBlock& position, double* window,
                                        double gravity, [[maybe_unused]] CellRuns* runs) {
  constexpr std::size_t rows = Boxes::rows;
  constexpr bool wet = force && coupling != PoreWaterCoupling::none;
  const NodeArray nodes(position);
  const Axis x_axis(lattice.x0, lattice.h);
  const Axis y_axis(lattice.y0, lattice.h);
  const Boxes boxes(p, lattice, x_axis);
  const Lanes g = all(p.weight_share * gravity);
  ChunkWeights<rows> w;
  FirstNodes seen(position, rows);
  ChunkStore store;
  if constexpr (wet)
    if (runs != nullptr)
      runs->restart(rows);
  for (std::size_t k = range.begin; k < range.end; k += chunk) {
    const std::size_t count = std::min(chunk, range.end - k);
    if constexpr (wet)
      if (runs != nullptr)
        runs->expect(count);
    by_fours(0, count, [&](std::size_t c, auto group) {
      take_weights<force, motion != Motion::none && around != Around::uniform, wet>(
          p, k + c, c, group, nodes, x_axis, y_axis, boxes, w, seen);
    });
    if (!seen.in_window())
      refuse_stray(p, k, k + count, position, x_axis, y_axis, boxes);
    Arrays soil = SoilPhase::arrays<force>(p, k, count, window, store);
    if constexpr (around == Around::bilinear) {
      soil.cross_x = &p.cross_x[k];
      soil.cross_y = &p.cross_y[k];
    }
    if constexpr (wet) {
      soil.buoyancy = (1.0 - p.weight_share) * gravity;
      soil.grains_per_mass = p.water->grains_per_mass;
      soil.begin = k;
      soil.runs = runs;
    }
    scatter_phase<SoilPhase::pull, motion, force, around, wet>(soil, count, w, lattice.h, g);
    if constexpr (coupling == PoreWaterCoupling::flow) {
      Arrays water = WaterPhase::arrays<force>(p, k, count, window, store);
      water.resistance = p.water->resistance();
      scatter_phase<WaterPhase::pull, motion, force, around>(water, count, w, lattice.h, g);
    }
  }
  return seen.rows();
}

/// Scatters numbers of the particles of a range.
/// @param window    where the sums of the first number stand
/// @param values_of  (k, group) -> the numbers of a group of particles from k on
/// @returns the rows of the lattice that the particles touch
template <std::size_t count, typename Boxes, typename ValuesOf>
[[gnu::flatten]] RowRange scatter_scalars(const Particles& p, const ParticleRange& range,
                                          const Lattice& lattice, const NodeBlock& position, double* window,
                                          const ValuesOf& values_of) {
  const NodeArray nodes(position);
  const Axis x_axis(lattice.x0, lattice.h);
  const Axis y_axis(lattice.y0, lattice.h);
  const Boxes boxes(p, lattice, x_axis);
  ChunkWeights<Boxes::rows> w;
  FirstNodes seen(position, Boxes::rows);
  for (std::size_t k = range.begin; k < range.end; k += chunk) {
    const std::size_t part = std::min(chunk, range.end - k);
    by_fours(0, part, [&](std::size_t c, auto group) {
      take_weights<false, false>(p, k + c, c, group, nodes, x_axis, y_axis, boxes, w, seen);
    });
    if (!seen.in_window())
      refuse_stray(p, k, k + part, position, x_axis, y_axis, boxes);
    scatter_numbers<count>(k, part, w, window, values_of);
  }
  return seen.rows();
}

/// Scatters the particles of a set in a tile, by the boxes and velocities that the set has.
/// @param runs  take the shares of pore volumes, if these are summed up
/// @returns the rows of the lattice that they touch
template <PoreWaterCoupling coupling, Motion motion, bool force>
RowRange scatter_set(const Ground& ground, const Particles& p, int clock, std::size_t tile, double* window,
                     CellRuns* runs = nullptr) {
  const ParticleRange range = p.in_block(ground.block(clock, tile));
  if (range.begin == range.end)
    return {};
  const Lattice& lattice = ground.tiles.lattice(ground.tiles.level_of(tile));
  const NodeBlock position = ground.tiles.window(tile);
  const double gravity = ground.spec.gravity;
  if constexpr (coupling == PoreWaterCoupling::none && !force)
    if (p.traits.bilinear)
      return scatter_range<coupling, motion, force, Around::bilinear, OneSquare>(p, range, lattice, position,
                                                                                 window, gravity, runs);
  return for_boxes(p, [&]<typename Boxes>() {
    return p.traits.affine
               ? scatter_range<coupling, motion, force, Around::affine, Boxes>(p, range, lattice, position,
                                                                               window, gravity, runs)
               : scatter_range<coupling, motion, force, Around::uniform, Boxes>(p, range, lattice, position,
                                                                                window, gravity, runs);
  });
}

/// scatter_scalars() for the particles of a set in a tile. Their sums begin with those of a field.
template <std::size_t count, typename ValuesOf>
RowRange scatter_scalars(const Ground& ground, const Particles& p, int clock, std::size_t tile,
                         double* window, Sum first, const ValuesOf& values_of) {
  const ParticleRange range = p.in_block(ground.block(clock, tile));
  if (range.begin == range.end)
    return {};
  return for_boxes(p, [&]<typename Boxes>() {
    return scatter_scalars<count, Boxes>(p, range, ground.tiles.lattice(ground.tiles.level_of(tile)),
                                         ground.tiles.window(tile),
                                         window + static_cast<std::size_t>(first) * window_nodes, values_of);
  });
}

/// The fields of particle_sums that a pass sums up.
template <typename Phase>
constexpr SumRange fields_of(Motion motion, bool force) {
  constexpr auto first = static_cast<std::size_t>(Phase::first_sum);
  const Sum from = motion == Motion::mass_and_momentum ? Sum::mass
                   : motion == Motion::momentum        ? Sum::momentum_x
                                                       : Sum::force_x;
  const SumRange fields = sums_between(from, force ? Sum::force_y : Sum::momentum_y);
  return {first + fields.first, first + fields.end + (force ? Phase::scalars : 0)};
}

/// Adds up what a tile's particles that touch several lattices bring to four nodes at a time.
/// @param add_to  (particle, weights of four, add) calls add(sum, lanes)
template <typename AddTo>
void add_across_tile(AcrossTile& tile, SumRange fields, const AddTo& add_to) {
  const std::size_t field = 4 * tile.weights.fours().size(); // length of one field in `tile.sums`
  std::fill(tile.sums.data() + fields.first * field, tile.sums.data() + fields.end * field, 0.0);
  for (std::size_t k = tile.weights.first(); k < tile.weights.end(); ++k)
    for (const FourWeights& w : tile.weights.of(k))
      add_to(k, w, [&](std::size_t sum, const Lanes& values) {
        double* to = &tile.sums[sum * field + std::size_t{4} * w.position];
        store(to, load(to) + values);
      });
}

template <typename Phase, Motion motion, bool force, bool affine>
void scatter_across(const Particles& p, AcrossTile& tile, const BasisCells& cells, double gravity) {
  constexpr auto first = static_cast<std::size_t>(Phase::first_sum);
  constexpr auto at = [](Sum sum) { return first + static_cast<std::size_t>(sum); };
  add_across_tile(
      tile, fields_of<Phase>(motion, force), [&](std::size_t k, const FourWeights& w, const auto& add) {
        const ParticleValues of = Phase::template of<affine>(p, k);
        const Lanes mass = of.mass * w.s;
        if constexpr (motion != Motion::none) {
          Lanes vx = all(of.vx);
          Lanes vy = all(of.vy);
          if constexpr (affine) {
            const InverseMoments& per = tile.weights.per_moments(k); // C = B D^-1
            const FourNodes& nodes = cells.four(w.four);
            const Lanes dx = nodes.x - p.x[k];
            const Lanes dy = nodes.y - p.y[k];
            vx += of.bxx * per.x * dx + of.bxy * per.y * dy;
            vy += of.byx * per.x * dx + of.byy * per.y * dy;
          }
          if constexpr (motion == Motion::mass_and_momentum)
            add(at(Sum::mass), mass);
          add(at(Sum::momentum_x), mass * vx);
          add(at(Sum::momentum_y), mass * vy);
        }
        if constexpr (force) {
          const auto& [sxx, syy, sxy] = of.stress;
          const double v = p.volume[k];
          add(at(Sum::force_x), -v * (sxx * w.gx + sxy * w.gy));
          add(at(Sum::force_y), -v * (sxy * w.gx + syy * w.gy) - gravity * mass);
          if constexpr (Phase::scalars > 0) {
            const std::array<Lanes, Phase::scalars> values = Phase::scalars_of(p, k, FewerThanFour(1));
            for (std::size_t f = 0; f < Phase::scalars; ++f)
              add(Phase::first_scalar + f, values[f][0] * w.s);
          }
        }
      });
}

template <typename Phase, Motion motion, bool force>
void scatter_across_set(Ground& ground, AcrossTile& tile) {
  const Particles& p = ground.sets[tile.set];
  const double gravity = Phase::pull == Pull::stress_and_weight ? p.weight_share * ground.spec.gravity : 0.0;
  p.traits.affine ? scatter_across<Phase, motion, force, true>(p, tile, ground.basis_cells, gravity)
                  : scatter_across<Phase, motion, force, false>(p, tile, ground.basis_cells, gravity);
}

} // namespace tremolo::mpm_domain
