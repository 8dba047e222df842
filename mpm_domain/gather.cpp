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
};

/// Sums over a particle's nine nodes; lanes as in NodeMotion.
struct Sample {
  Lanes v{};        ///< sum S v
  Lanes dx{};       ///< sum dS/dx v
  Lanes dy{};       ///< sum dS/dy v
  Lanes moment_x{}; ///< sum S v (x_i - x_p)
  Lanes moment_y{};
  double inertia_x = 1.0;
  double inertia_y = 1.0;
};

template <bool value, bool gradient, bool moment>
Sample sample(const Grid& grid, double x, double y, const Axis& x_axis, const Axis& y_axis) {
  const Weights wx = gimp_weights(x, x_axis);
  const Weights wy = gimp_weights(y, y_axis);
  Sample q;
  const NodeMotion* row = &grid.motion[grid.index(wx.base, wy.base)];
  for (int j = 0; j < 3; ++j, row += grid.nx)
    for (int i = 0; i < 3; ++i) {
      const Lanes u = row[i].velocity;
      if constexpr (value || moment) {
        const Lanes su = (wx.s[i] * wy.s[j]) * u;
        q.v += su;
        if constexpr (moment) {
          q.moment_x += wx.d[i] * su;
          q.moment_y += wy.d[j] * su;
        }
      }
      if constexpr (gradient) {
        q.dx += (wx.g[i] * wy.s[j]) * u;
        q.dy += (wx.s[i] * wy.g[j]) * u;
      }
    }
  if constexpr (moment) {
    q.inertia_x = second_moment(wx);
    q.inertia_y = second_moment(wy);
  }
  return q;
}

void take_affine(Particles& p, std::size_t k, const Sample& q) {
  p.vx[k] = q.v[2];
  p.vy[k] = q.v[3];
  p.cxx[k] = q.moment_x[2] / q.inertia_x;
  p.cyx[k] = q.moment_x[3] / q.inertia_x;
  p.cxy[k] = q.moment_y[2] / q.inertia_y;
  p.cyy[k] = q.moment_y[3] / q.inertia_y;
}

void take_blend(Particles& p, std::size_t k, const Sample& q, double flip_share) {
  p.vx[k] = flip_share * (p.vx[k] + q.v[2] - q.v[0]) + (1.0 - flip_share) * q.v[2];
  p.vy[k] = flip_share * (p.vy[k] + q.v[3] - q.v[1]) + (1.0 - flip_share) * q.v[3];
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
  int strain_lane;   ///< of NodeMotion: 0 the first velocity, 2 v+
};

template <bool velocity, bool position, bool strain, bool affine>
GatherSums gather_range(Domain& domain, Particles& p, std::size_t begin, std::size_t end,
                        const Settings& set) {
  const Axis x_axis = domain.x_axis();
  const Axis y_axis = domain.y_axis();
  const int a = set.strain_lane;
  GatherSums work;
  double max_speed2 = 0.0;
  Increments inc;
  for (std::size_t first = begin; first < end; first += chunk) {
    const std::size_t count = std::min(chunk, end - first);
    for (std::size_t c = 0; c < count; ++c) {
      const std::size_t k = first + c;
      const Sample q = sample < velocity || position, strain,
                   velocity && affine > (domain.grid, p.x[k], p.y[k], x_axis, y_axis);
      if constexpr (velocity) {
        if constexpr (affine)
          take_affine(p, k, q);
        else
          take_blend(p, k, q, set.flip_share);
      }
      if constexpr (strain) {
        inc.exx[c] = set.dt * q.dx[a];
        inc.eyy[c] = set.dt * q.dy[a + 1];
        inc.gxy[c] = set.dt * (q.dy[a] + q.dx[a + 1]);
        inc.wxy[c] = 0.5 * set.dt * (q.dx[a + 1] - q.dy[a]);
      }
      if constexpr (position) {
        p.x[k] += set.dt * q.v[2];
        p.y[k] += set.dt * q.v[3];
        max_speed2 = std::max(max_speed2, q.v[2] * q.v[2] + q.v[3] * q.v[3]);
      }
    }
    if constexpr (strain) {
      const GatherSums part = strain_chunk(p, first, count, inc);
      work.elastic += part.elastic;
      work.plastic += part.plastic;
    }
  }
  work.max_speed = std::sqrt(max_speed2);
  return work;
}

template <bool velocity, bool position, bool strain>
GatherSums gather_blocks(Domain& domain, const Settings& settings) {
  std::vector<GatherSums> sums(domain.block_count());
  domain.workers.run(sums.size(), [&](std::size_t block) {
    for (Particles& p : domain.sets) {
      const std::size_t begin = p.block_start[block];
      const std::size_t end = p.block_start[block + 1];
      const GatherSums work =
          p.cxx.empty() ? gather_range<velocity, position, strain, false>(domain, p, begin, end, settings)
                        : gather_range<velocity, position, strain, true>(domain, p, begin, end, settings);
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

} // namespace

GatherSums gather(Domain& domain, double dt, GatherParts parts, bool strain_of_first) {
  const Scheme& scheme = domain.spec.scheme;
  const double flip_share = scheme.transfer == Transfer::pic_blend ? std::exp(-dt / scheme.blend_time) : 1.0;
  const Settings settings{dt, flip_share, strain_of_first ? 0 : 2};
  if (parts.velocity && parts.position && parts.strain)
    return gather_blocks<true, true, true>(domain, settings);
  if (parts.velocity && parts.position)
    return gather_blocks<true, true, false>(domain, settings);
  if (parts.position && parts.strain)
    return gather_blocks<false, true, true>(domain, settings);
  if (parts.velocity && !parts.strain)
    return gather_blocks<true, false, false>(domain, settings);
  if (parts.strain && !parts.velocity && !parts.position)
    return gather_blocks<false, false, true>(domain, settings);
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
