#pragma once

// Interpolation of velocities from the grid to particles, four at a time. On one lattice they use stencils;
// across several lattices they read node by node.

#include "mpm_domain/ground.hpp"
#include "mpm_domain/transfer/stencil.hpp"

#include <array>

namespace tremolo::mpm_domain {

/// The sums of a velocity component that are computed.
struct Reading {
  bool value = false;
  bool gradient = false;
  bool moments = false;
  bool cross_moment = false;
};

/// A velocity component as four particles read it.
struct Component {
  Lanes value{};                ///< sum S v
  Lanes d_dx{}, d_dy{};         ///< its gradient, 1/s
  Lanes moment_x{}, moment_y{}; ///< sum S v (x_i - x), m2/s
  Lanes cross_moment{};         ///< sum S v (x_i - x)(y_i - y), m3/s
};

/// Four columns of nodes as four particles see them: [column][particle] of both components.
struct Columns {
  std::array<Lanes, 4> x{}, y{};
};

/// Reads with the stencils of four particles. There is a factor per node along x and one per row along y; the
/// latter is loaded from memory into all lanes.
template <std::size_t rows>
struct Reader {
  using Factors = std::array<std::array<double, 4>, rows>; ///< [row][particle]

  std::size_t count;                 ///< particles among the four lanes
  std::array<std::int32_t, 4> first; ///< first node of each particle's stencil
  std::ptrdiff_t row;                ///< nodes from one row to the next
  CellWeights<Lanes> x;
  std::array<Lanes, 4> x_moment; ///< S (x_i - x), m
  alignas(32) Factors y_s, y_g, y_moment;

  template <typename Boxes>
  Reader(const Stencils& at, std::size_t particles, const Lattice& lattice, const Axis& x_axis,
         const Axis& y_axis, const Boxes& boxes)
      : count(particles), first(at.first_nodes(NodeArray(lattice))), row(lattice.nx),
        x(boxes.along_x(at.xi, x_axis)) {
    for (std::size_t i = 0; i < 4; ++i)
      x_moment[i] = x.s[i] * (x_axis.h * (static_cast<double>(i) - 1.0 - at.xi));
    const auto y = boxes.along_y(at.eta, y_axis);
    for (std::size_t j = 0; j < rows; ++j) {
      store(y_s[j].data(), y.s[j]);
      store(y_g[j].data(), y.g[j]);
      store(y_moment[j].data(), y.s[j] * (y_axis.h * (static_cast<double>(j) - at.eta)));
    }
  }

  /// Adds up the rows in each of a particle's four columns, then transposes: the result has one particle a
  /// lane. Both components are read together since they have their factors in common.
  [[gnu::always_inline]] Columns columns(const NodeField& field_x, const NodeField& field_y,
                                         const Factors& factors) const {
    const double* const nodes_x = field_x.data();
    const double* const nodes_y = field_y.data();
    Columns sums;
    for (std::size_t k = 0; k < count; ++k) {
      std::ptrdiff_t n = first[k];
      Lanes factor = all(factors[0][k]);
      sums.x[k] = factor * load(nodes_x + n);
      sums.y[k] = factor * load(nodes_y + n);
      for (std::size_t j = 1; j < rows; ++j) {
        n += row;
        factor = all(factors[j][k]);
        sums.x[k] += factor * load(nodes_x + n);
        sums.y[k] += factor * load(nodes_y + n);
      }
    }
    return {transposed(sums.x), transposed(sums.y)};
  }

  template <Reading reading>
  [[gnu::always_inline]] void read(const NodeField& field_x, const NodeField& field_y, Component& vx,
                                   Component& vy) const {
    const Columns s = columns(field_x, field_y, y_s);
    if constexpr (reading.value) {
      vx.value = dot(x.s, s.x);
      vy.value = dot(x.s, s.y);
    }
    if constexpr (reading.gradient) {
      const Columns g = columns(field_x, field_y, y_g);
      vx.d_dx = dot(x.g, s.x);
      vy.d_dx = dot(x.g, s.y);
      vx.d_dy = dot(x.s, g.x);
      vy.d_dy = dot(x.s, g.y);
    }
    if constexpr (reading.moments) {
      const Columns m = columns(field_x, field_y, y_moment);
      vx.moment_x = dot(x_moment, s.x);
      vy.moment_x = dot(x_moment, s.y);
      vx.moment_y = dot(x.s, m.x);
      vy.moment_y = dot(x.s, m.y);
      if constexpr (reading.cross_moment) {
        vx.cross_moment = dot(x_moment, m.x);
        vy.cross_moment = dot(x_moment, m.y);
      }
    }
  }

  /// sum of a field of vectors times grad S
  [[gnu::always_inline]] Lanes divergence(const NodeField& field_x, const NodeField& field_y) const {
    std::array<Lanes, 4> along{};
    std::array<Lanes, 4> up{};
    for (std::size_t k = 0; k < count; ++k) {
      const double* nodes_x = field_x.data() + first[k];
      const double* nodes_y = field_y.data() + first[k];
      along[k] = y_s[0][k] * load(nodes_x);
      up[k] = y_g[0][k] * load(nodes_y);
      for (std::size_t j = 1; j < rows; ++j) {
        along[k] += y_s[j][k] * load(nodes_x += row);
        up[k] += y_g[j][k] * load(nodes_y += row);
      }
    }
    return dot(x.g, transposed(along)) + dot(x.s, transposed(up));
  }

  /// sum over the four nodes of a row
  static Lanes dot(const std::array<Lanes, 4>& a, const std::array<Lanes, 4>& b) {
    return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
  }
};

/// A vector of four particles.
struct Vectors {
  Lanes x{}, y{};
};

/// Values that four particles read from the grid.
struct Samples {
  Vectors v_before;                     ///< sum S v-
  Vectors v_after;                      ///< sum S v+
  Lanes vx_x{}, vx_y{}, vy_x{}, vy_y{}; ///< d v_a/d x_b of the velocity that strains, 1/s
  Lanes bxx{}, bxy{}, byx{}, byy{};     ///< sum S v+ (x_i - x)^T, m2/s
  Vectors cross;                        ///< sum S v+ (x_i - x)(y_i - y), m3/s
};

/// The velocities that a gather samples, and the one that gives the strain.
struct Wanted {
  bool v_before = false;
  bool v_after = false;
  bool gradient = false;
  bool remapped = false; ///< the gradient is that of the remapped velocity, not of v+
  bool affine = false;
  bool bilinear = false; ///< besides affine
};

/// The fields of the grid that are sampled: velocities before and after the update, and that which strains.
struct VelocityFields {
  const NodeField &x_before, &y_before, &x_after, &y_after, &x_strain, &y_strain;
};
inline VelocityFields of_soil(const Grid& grid) {
  return {grid.vx_before, grid.vy_before, grid.vx_after, grid.vy_after, grid.vx_strain, grid.vy_strain};
}
/// The velocities of water that flows. What strains it is the flux of grains and water.
inline VelocityFields of_water(const Grid& grid) {
  return {grid.wx_before, grid.wy_before, grid.wx_after, grid.wy_after, grid.flux_x, grid.flux_y};
}

/// Both components of the velocities of the grid, as far as they are wanted.
struct Velocities {
  Component x_before, y_before, x_after, y_after, x_strain, y_strain;
};

template <Wanted wanted>
constexpr Reading of_before{.value = wanted.v_before};

template <Wanted wanted>
constexpr Reading of_after{.value = wanted.v_after,
                           .gradient = wanted.gradient && !wanted.remapped,
                           .moments = wanted.affine,
                           .cross_moment = wanted.bilinear};

template <Wanted wanted>
constexpr Reading of_strain{.gradient = wanted.gradient && wanted.remapped};

constexpr bool reads(Reading reading) {
  return reading.value || reading.gradient || reading.moments;
}

template <Wanted wanted>
[[gnu::always_inline]] inline Samples samples_of(const Velocities& read) {
  const Component& ux = wanted.remapped ? read.x_strain : read.x_after;
  const Component& uy = wanted.remapped ? read.y_strain : read.y_after;
  return {.v_before = {read.x_before.value, read.y_before.value},
          .v_after = {read.x_after.value, read.y_after.value},
          .vx_x = ux.d_dx,
          .vx_y = ux.d_dy,
          .vy_x = uy.d_dx,
          .vy_y = uy.d_dy,
          .bxx = read.x_after.moment_x,
          .bxy = read.x_after.moment_y,
          .byx = read.y_after.moment_x,
          .byy = read.y_after.moment_y,
          .cross = {read.x_after.cross_moment, read.y_after.cross_moment}};
}

/// Values that the four particles of a reader read from the grid.
template <Wanted wanted, std::size_t rows>
[[gnu::always_inline]] inline Samples samples_at(const Reader<rows>& at, const VelocityFields& v) {
  Velocities read;
  if constexpr (reads(of_before<wanted>))
    at.template read<of_before<wanted>>(v.x_before, v.y_before, read.x_before, read.y_before);
  if constexpr (reads(of_after<wanted>))
    at.template read<of_after<wanted>>(v.x_after, v.y_after, read.x_after, read.y_after);
  if constexpr (reads(of_strain<wanted>))
    at.template read<of_strain<wanted>>(v.x_strain, v.y_strain, read.x_strain, read.y_strain);
  return samples_of<wanted>(read);
}

template <Wanted wanted, std::size_t rows, typename Boxes>
[[gnu::always_inline]] inline Samples sample(const VelocityFields& v, const Lattice& lattice, const Lanes& x,
                                             const Lanes& y, std::size_t count, const Axis& x_axis,
                                             const Axis& y_axis, const Boxes& boxes) {
  const Reader<rows> at(Stencils(x, y, x_axis, y_axis, boxes), count, lattice, x_axis, y_axis, boxes);
  return samples_at<wanted>(at, v);
}

/// Reads four nodes, one a lane, of a particle that touches several lattices.
struct NodesReader {
  const FourWeights& w;
  Lanes dx, dy; ///< of the nodes from the particle, m

  template <Reading reading>
  [[gnu::always_inline]] void add(const NodeField& field, Component& sums) const {
    if constexpr (reads(reading)) {
      const auto& n = w.node;
      const Lanes v{field[n[0]], field[n[1]], field[n[2]], field[n[3]]};
      if constexpr (reading.value)
        sums.value += w.s * v;
      if constexpr (reading.gradient) {
        sums.d_dx += w.gx * v;
        sums.d_dy += w.gy * v;
      }
      if constexpr (reading.moments) {
        sums.moment_x += w.s * v * dx;
        sums.moment_y += w.s * v * dy;
      }
    }
  }
};

/// Adds up the four lanes of each of a particle's sums and stores the result in the particle's lane.
template <Reading reading>
[[gnu::always_inline]] inline void collect(const Component& sums, std::size_t lane, Component& particles) {
  if constexpr (reading.value)
    particles.value[lane] = sum(sums.value);
  if constexpr (reading.gradient) {
    particles.d_dx[lane] = sum(sums.d_dx);
    particles.d_dy[lane] = sum(sums.d_dy);
  }
  if constexpr (reading.moments) {
    particles.moment_x[lane] = sum(sums.moment_x);
    particles.moment_y[lane] = sum(sums.moment_y);
  }
}

/// sample() for `count` particles from `first` on that touch several lattices.
template <Wanted wanted>
Samples sample_across(const VelocityFields& v, const AcrossWeights& weights, const BasisCells& cells,
                      const Particles& p, std::size_t first, std::size_t count) {
  Velocities read;
  for (std::size_t lane = 0; lane < count; ++lane) {
    const std::size_t k = first + lane;
    Velocities sums;
    for (const FourWeights& w : weights.of(k)) {
      const FourNodes& nodes = cells.four(w.four);
      const NodesReader at{w, nodes.x - p.x[k], nodes.y - p.y[k]};
      at.add<of_before<wanted>>(v.x_before, sums.x_before);
      at.add<of_before<wanted>>(v.y_before, sums.y_before);
      at.add<of_after<wanted>>(v.x_after, sums.x_after);
      at.add<of_after<wanted>>(v.y_after, sums.y_after);
      at.add<of_strain<wanted>>(v.x_strain, sums.x_strain);
      at.add<of_strain<wanted>>(v.y_strain, sums.y_strain);
    }
    collect<of_before<wanted>>(sums.x_before, lane, read.x_before);
    collect<of_before<wanted>>(sums.y_before, lane, read.y_before);
    collect<of_after<wanted>>(sums.x_after, lane, read.x_after);
    collect<of_after<wanted>>(sums.y_after, lane, read.y_after);
    collect<of_strain<wanted>>(sums.x_strain, lane, read.x_strain);
    collect<of_strain<wanted>>(sums.y_strain, lane, read.y_strain);
  }
  return samples_of<wanted>(read);
}

} // namespace tremolo::mpm_domain
