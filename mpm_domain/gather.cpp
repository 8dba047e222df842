#include "mpm_domain/gather.hpp"

#include "materials/law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Particles whose increments are held at a time between the grid and the law.
constexpr std::size_t chunk = 128;

struct Increments {
  std::array<double, chunk> exx, eyy, gxy, wxy;
  std::array<double, chunk> sxx, syy, sxy, plastic; ///< stress before the update; plastic work per volume

  /// @param gradient  { dvx/dx, dvy/dx, dvx/dy, dvy/dy }, 1/s
  void take(std::size_t c, const Lanes& gradient, double dt) {
    exx[c] = dt * gradient[0];
    eyy[c] = dt * gradient[3];
    gxy[c] = dt * (gradient[2] + gradient[1]);
    wxy[c] = 0.5 * dt * (gradient[1] - gradient[2]);
  }
};

/// What a particle reads off the grid.
struct Sample {
  Vector v;                 ///< sum S v, before the update
  Vector v_new;             ///< after it
  Lanes gradient{};         ///< { dvx/dx, dvy/dx, dvx/dy, dvy/dy } of the velocity that strains
  Lanes moment{};           ///< sum S v_new (x_i - x): { vx x, vy x, vx y, vy y }
  Vector inertia{1.0, 1.0}; ///< sum S (x_i - x)^2
};

/// A velocity field's sums over the three rows, with the weights of y, its gradients, its moments.
struct Columns {
  Lanes s{}, g{}, d{};
};

/// @param dy  rows minus particle, m
template <bool gradient, bool moment>
inline void add_row(const double* nodes, double s, double g, double dy, Columns& columns) {
  const Lanes v = load(nodes);
  columns.s += s * v;
  if constexpr (gradient)
    columns.g += g * v;
  if constexpr (moment)
    columns.d += s * dy * v;
}

/// Which velocities a gather samples, and which of them strains.
struct Wanted {
  bool v = false;
  bool v_new = false;
  bool gradient = false;
  bool of_v = false; ///< the gradient, not of v_new
  bool moment = false;
};

template <Wanted wanted>
inline Sample sample(const Grid& grid, double x, double y, const Axis& x_axis, const Axis& y_axis) {
  constexpr bool gradient_of_v = wanted.gradient && wanted.of_v;
  constexpr bool gradient_of_new = wanted.gradient && !wanted.of_v;
  constexpr bool reads_v = wanted.v || gradient_of_v;
  constexpr bool reads_new = wanted.v_new || wanted.moment || gradient_of_new;
  const Weights wx = cell_weights(x, x_axis);
  const Weights wy = gimp_weights(y, y_axis);
  [[maybe_unused]] Lanes dy{};
  if constexpr (wanted.moment)
    dy = offsets(wy, y, y_axis);
  Columns vx, vy, vx_new, vy_new;
  const std::size_t first = grid.index(wx.base, wy.base);
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t n = first + j * static_cast<std::size_t>(grid.nx);
    if constexpr (reads_v) {
      add_row<gradient_of_v, false>(&grid.vx[n], wy.s[j], wy.g[j], 0.0, vx);
      add_row<gradient_of_v, false>(&grid.vy[n], wy.s[j], wy.g[j], 0.0, vy);
    }
    if constexpr (reads_new) {
      add_row<gradient_of_new, wanted.moment>(&grid.vx_new[n], wy.s[j], wy.g[j], dy[j], vx_new);
      add_row<gradient_of_new, wanted.moment>(&grid.vy_new[n], wy.s[j], wy.g[j], dy[j], vy_new);
    }
  }
  Sample q;
  if constexpr (wanted.v || wanted.v_new) {
    const Lanes values = sums(wx.s * vx.s, wx.s * vy.s, wx.s * vx_new.s, wx.s * vy_new.s);
    q.v = {values[0], values[1]};
    q.v_new = {values[2], values[3]};
  }
  if constexpr (wanted.gradient) {
    const Columns& ux = wanted.of_v ? vx : vx_new;
    const Columns& uy = wanted.of_v ? vy : vy_new;
    q.gradient = sums(wx.g * ux.s, wx.g * uy.s, wx.s * ux.g, wx.s * uy.g);
  }
  if constexpr (wanted.moment) {
    const Lanes dx = offsets(wx, x, x_axis);
    const Lanes s_dx = wx.s * dx;
    q.moment = sums(s_dx * vx_new.s, s_dx * vy_new.s, wx.s * vx_new.d, wx.s * vy_new.d);
    q.inertia = {second_moment(wx, dx), second_moment(wy, dy)};
  }
  return q;
}

void take_affine(Particles& p, std::size_t k, const Sample& q) {
  p.vx[k] = q.v_new.x;
  p.vy[k] = q.v_new.y;
  p.cxx[k] = q.moment[0] / q.inertia.x;
  p.cyx[k] = q.moment[1] / q.inertia.x;
  p.cxy[k] = q.moment[2] / q.inertia.y;
  p.cyy[k] = q.moment[3] / q.inertia.y;
}

void take_blend(Particles& p, std::size_t k, const Sample& q, double flip_share) {
  p.vx[k] = flip_share * (p.vx[k] + q.v_new.x - q.v.x) + (1.0 - flip_share) * q.v_new.x;
  p.vy[k] = flip_share * (p.vy[k] + q.v_new.y - q.v.y) + (1.0 - flip_share) * q.v_new.y;
}

/// The strain part of a chunk: law, volumes, and the work done.
GatherSums strain_chunk(Particles& p, std::size_t begin, std::size_t count, Increments& inc) {
  for (std::size_t c = 0; c < count; ++c) {
    inc.sxx[c] = p.sxx[begin + c];
    inc.syy[c] = p.syy[begin + c];
    inc.sxy[c] = p.sxy[begin + c];
    inc.plastic[c] = 0.0;
  }
  materials::Points points = p.points(begin, count);
  points.plastic_work = inc.plastic.data();
  points.dexx = inc.exx.data();
  points.deyy = inc.eyy.data();
  points.dgxy = inc.gxy.data();
  points.dwxy = inc.wxy.data();
  materials::update(p.law, points);
  GatherSums work;
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t k = begin + c;
    const double total = 0.5 * ((inc.sxx[c] + p.sxx[k]) * inc.exx[c] + (inc.syy[c] + p.syy[k]) * inc.eyy[c] +
                                (inc.sxy[c] + p.sxy[k]) * inc.gxy[c]);
    work.elastic += p.volume[k] * (total - inc.plastic[c]);
    work.plastic += p.volume[k] * inc.plastic[c];
    p.volume[k] *= 1.0 + inc.exx[c] + inc.eyy[c];
  }
  return work;
}

struct Settings {
  double dt;
  double flip_share; ///< exp(-dt/tau); 1 for pure FLIP
};

template <GatherParts parts, bool strain_of_first, bool affine>
GatherSums gather_range(Domain& domain, Particles& p, std::size_t begin, std::size_t end,
                        const Settings& set) {
  constexpr Wanted wanted{.v = parts.velocity && !affine,
                          .v_new = parts.velocity || parts.position,
                          .gradient = parts.strain,
                          .of_v = strain_of_first,
                          .moment = parts.velocity && affine};
  const Axis x_axis = domain.x_axis();
  const Axis y_axis = domain.y_axis();
  GatherSums work;
  double max_speed2 = 0.0;
  Increments inc;
  for (std::size_t first = begin; first < end; first += chunk) {
    const std::size_t count = std::min(chunk, end - first);
    for (std::size_t c = 0; c < count; ++c) {
      const std::size_t k = first + c;
      const Sample q = sample<wanted>(domain.grid, p.x[k], p.y[k], x_axis, y_axis);
      if constexpr (parts.velocity) {
        if constexpr (affine)
          take_affine(p, k, q);
        else
          take_blend(p, k, q, set.flip_share);
      }
      if constexpr (parts.strain)
        inc.take(c, q.gradient, set.dt);
      if constexpr (parts.position) {
        p.x[k] += set.dt * q.v_new.x;
        p.y[k] += set.dt * q.v_new.y;
        max_speed2 = std::max(max_speed2, q.v_new.x * q.v_new.x + q.v_new.y * q.v_new.y);
      }
    }
    if constexpr (parts.strain) {
      const GatherSums part = strain_chunk(p, first, count, inc);
      work.elastic += part.elastic;
      work.plastic += part.plastic;
    }
  }
  work.max_speed = std::sqrt(max_speed2);
  return work;
}

template <GatherParts parts, bool strain_of_first>
GatherSums gather_blocks(Domain& domain, const Settings& settings) {
  std::vector<GatherSums> sums(domain.block_count());
  domain.workers.run(sums.size(), [&](std::size_t block) {
    for (Particles& p : domain.sets) {
      const std::size_t begin = p.block_start[block];
      const std::size_t end = p.block_start[block + 1];
      const GatherSums work =
          p.cxx.empty() ? gather_range<parts, strain_of_first, false>(domain, p, begin, end, settings)
                        : gather_range<parts, strain_of_first, true>(domain, p, begin, end, settings);
      sums[block].elastic += work.elastic;
      sums[block].plastic += work.plastic;
      sums[block].max_speed = std::max(sums[block].max_speed, work.max_speed);
    }
  });
  GatherSums total;
  for (const GatherSums& sum : sums) {
    total.elastic += sum.elastic;
    total.plastic += sum.plastic;
    total.max_speed = std::max(total.max_speed, sum.max_speed);
  }
  return total;
}

constexpr GatherParts all_parts{.velocity = true, .position = true, .strain = true};
constexpr GatherParts motion_parts{.velocity = true, .position = true};
constexpr GatherParts velocity_part{.velocity = true};
constexpr GatherParts rest_parts{.position = true, .strain = true};
constexpr GatherParts strain_part{.strain = true};

} // namespace

GatherSums gather(Domain& domain, double dt, GatherParts parts, bool strain_of_first) {
  const Scheme& scheme = domain.spec.scheme;
  const double flip_share = scheme.transfer == Transfer::pic_blend ? std::exp(-dt / scheme.blend_time) : 1.0;
  const Settings settings{dt, flip_share};
  if (parts == all_parts && !strain_of_first)
    return gather_blocks<all_parts, false>(domain, settings);
  if (parts == motion_parts)
    return gather_blocks<motion_parts, false>(domain, settings);
  if (parts == velocity_part)
    return gather_blocks<velocity_part, false>(domain, settings);
  if (parts == rest_parts && strain_of_first)
    return gather_blocks<rest_parts, true>(domain, settings);
  if (parts == strain_part)
    return strain_of_first ? gather_blocks<strain_part, true>(domain, settings)
                           : gather_blocks<strain_part, false>(domain, settings);
  throw std::logic_error("gather: no scheme asks for this combination of parts");
}

Vector particle_acceleration(const Domain& domain, const Particles& particles, std::size_t k) {
  const Weights wx = gimp_weights(particles.x[k], domain.x_axis());
  const Weights wy = gimp_weights(particles.y[k], domain.y_axis());
  Vector a;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const Vector node = domain.grid.acceleration[domain.grid.index(wx.base + i, wy.base + j)];
      a.x += wx.s[i] * wy.s[j] * node.x;
      a.y += wx.s[i] * wy.s[j] * node.y;
    }
  return a;
}

} // namespace tremolo::mpm_domain
