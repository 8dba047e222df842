#include "mpm_domain/gather.hpp"

#include "materials/law.hpp"
#include "mpm_domain/stencil.hpp"

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

/// A velocity component at the nodes of four particles' stencils, the three rows summed with the weights of
/// y, their gradients and their moments s (y_j - y): per particle a row of four nodes, and after turn() per
/// node the four particles.
struct Columns {
  std::array<Lanes, 4> s, g, d;

  template <bool value, bool gradient, bool moment>
  [[gnu::always_inline]] void turn() {
    if constexpr (value)
      s = transposed(s);
    if constexpr (gradient)
      g = transposed(g);
    if constexpr (moment)
      d = transposed(d);
  }
};

/// Factors of the three rows of four particles: s, ds/dy, s (y_j - y).
struct RowFactors {
  alignas(32) std::array<std::array<double, 4>, 3> s, g, d;
};

template <bool value, bool gradient, bool moment>
[[gnu::always_inline]] inline void add_rows(const double* nodes, std::size_t row, const RowFactors& y,
                                            std::size_t lane, Columns& columns) {
  Lanes s{};
  Lanes g{};
  Lanes d{};
  for (std::size_t j = 0; j < 3; ++j) {
    const Lanes v = load(nodes + j * row);
    if constexpr (value)
      s += y.s[j][lane] * v;
    if constexpr (gradient)
      g += y.g[j][lane] * v;
    if constexpr (moment)
      d += y.d[j][lane] * v;
  }
  columns.s[lane] = s;
  columns.g[lane] = g;
  columns.d[lane] = d;
}

/// sum over the four nodes of a row
[[gnu::always_inline]] inline Lanes dot(const std::array<Lanes, 4>& a, const std::array<Lanes, 4>& b) {
  return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}

/// A vector of four particles.
struct Vectors {
  Lanes x{}, y{};
};

/// What four particles read off the grid.
struct Samples {
  Vectors v;                            ///< sum S v, before the update
  Vectors v_new;                        ///< after it
  Lanes vx_x{}, vx_y{}, vy_x{}, vy_y{}; ///< d v_a/d x_b of the velocity that strains
  Lanes cxx{}, cxy{}, cyx{}, cyy{};     ///< sum S v_new (x_i - x)^T D^-1
};

/// Which velocities a gather samples, and which of them strains.
struct Wanted {
  bool v = false;
  bool v_new = false;
  bool gradient = false;
  bool of_v = false; ///< the gradient, not of v_new
  bool affine = false;
};

template <Wanted wanted>
[[gnu::always_inline]] inline Samples sample(const Grid& grid, const Lanes& x, const Lanes& y,
                                             std::size_t count, const Axis& x_axis, const Axis& y_axis) {
  constexpr bool gradient_of_v = wanted.gradient && wanted.of_v;
  constexpr bool gradient_of_new = wanted.gradient && !wanted.of_v;
  constexpr bool reads_v = wanted.v || gradient_of_v;
  constexpr bool reads_new = wanted.v_new || wanted.affine || gradient_of_new;
  const Stencils at(x, y, x_axis, y_axis);
  const CellWeights<Lanes> wx(at.xi, x_axis);
  const RowWeights<Lanes> wy(at.eta, y_axis);
  RowFactors rows;
  for (std::size_t j = 0; j < 3; ++j) {
    store(rows.s[j].data(), wy.s[j]);
    if constexpr (wanted.gradient)
      store(rows.g[j].data(), wy.g[j]);
    if constexpr (wanted.affine)
      store(rows.d[j].data(), wy.s[j] * (y_axis.h * (static_cast<double>(j) - at.eta)));
  }
  Columns vx;
  Columns vy;
  Columns vx_new;
  Columns vy_new;
  const auto row = static_cast<std::size_t>(grid.nx);
  const std::array<std::int32_t, 4> first = at.first_nodes(grid);
  for (std::size_t lane = 0; lane < count; ++lane) {
    const auto n = static_cast<std::size_t>(first[lane]);
    if constexpr (reads_v) {
      add_rows<true, gradient_of_v, false>(&grid.vx[n], row, rows, lane, vx);
      add_rows<true, gradient_of_v, false>(&grid.vy[n], row, rows, lane, vy);
    }
    if constexpr (reads_new) {
      add_rows<true, gradient_of_new, wanted.affine>(&grid.vx_new[n], row, rows, lane, vx_new);
      add_rows<true, gradient_of_new, wanted.affine>(&grid.vy_new[n], row, rows, lane, vy_new);
    }
  }
  Samples q;
  if constexpr (reads_v) {
    vx.turn<true, gradient_of_v, false>();
    vy.turn<true, gradient_of_v, false>();
  }
  if constexpr (reads_new) {
    vx_new.turn<true, gradient_of_new, wanted.affine>();
    vy_new.turn<true, gradient_of_new, wanted.affine>();
  }
  if constexpr (wanted.v)
    q.v = {dot(wx.s, vx.s), dot(wx.s, vy.s)};
  if constexpr (wanted.v_new)
    q.v_new = {dot(wx.s, vx_new.s), dot(wx.s, vy_new.s)};
  if constexpr (wanted.gradient) {
    const Columns& ux = wanted.of_v ? vx : vx_new;
    const Columns& uy = wanted.of_v ? vy : vy_new;
    q.vx_x = dot(wx.g, ux.s);
    q.vx_y = dot(wx.s, ux.g);
    q.vy_x = dot(wx.g, uy.s);
    q.vy_y = dot(wx.s, uy.g);
  }
  if constexpr (wanted.affine) {
    std::array<Lanes, 4> s_dx;
    for (std::size_t i = 0; i < 4; ++i)
      s_dx[i] = wx.s[i] * (x_axis.h * (static_cast<double>(i) - 1.0 - at.xi));
    const Lanes per_x = 1.0 / wx.second_moment;
    const Lanes per_y = 1.0 / wy.second_moment;
    q.cxx = dot(s_dx, vx_new.s) * per_x;
    q.cyx = dot(s_dx, vy_new.s) * per_x;
    q.cxy = dot(wx.s, vx_new.d) * per_y;
    q.cyy = dot(wx.s, vy_new.d) * per_y;
  }
  return q;
}

struct Settings {
  double dt;
  double flip_share; ///< exp(-dt/tau); 1 for pure FLIP
};

template <typename Group>
[[gnu::always_inline]] inline void take_affine(Particles& p, std::size_t k, Group group, const Samples& q) {
  group.store(&p.vx[k], q.v_new.x);
  group.store(&p.vy[k], q.v_new.y);
  group.store(&p.cxx[k], q.cxx);
  group.store(&p.cyx[k], q.cyx);
  group.store(&p.cxy[k], q.cxy);
  group.store(&p.cyy[k], q.cyy);
}

template <typename Group>
[[gnu::always_inline]] inline void take_blend(Particles& p, std::size_t k, Group group, const Samples& q,
                                              double flip_share) {
  const auto blend = [&](double* v, const Lanes& before, const Lanes& after) {
    group.store(v, flip_share * (group.load(v) + after - before) + (1.0 - flip_share) * after);
  };
  blend(&p.vx[k], q.v.x, q.v_new.x);
  blend(&p.vy[k], q.v.y, q.v_new.y);
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

  GatherSums collected() const {
    const Lanes& m = max_speed2;
    return {sum(total) - sum(plastic), sum(plastic),
            std::sqrt(std::max(std::max(m[0], m[1]), std::max(m[2], m[3])))};
  }
};

/// Strain and rotation increments, and half of the work: that of the stress before the update.
template <typename Group>
[[gnu::always_inline]] inline void take_strain(const Particles& p, std::size_t k, Group group,
                                               const Samples& q, double dt, std::size_t c, Increments& inc,
                                               LaneSums& sums) {
  store(&inc.exx[c], dt * q.vx_x);
  store(&inc.eyy[c], dt * q.vy_y);
  store(&inc.gxy[c], dt * (q.vx_y + q.vy_x));
  store(&inc.wxy[c], 0.5 * dt * (q.vy_x - q.vx_y));
  store(&inc.plastic[c], Lanes{});
  sums.total += 0.5 * group.load(&p.volume[k]) * work_density(p, k, inc, c, group);
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
    const Lanes volume = group.load(&p.volume[k]);
    sums.total += 0.5 * volume * work_density(p, k, inc, c, group);
    sums.plastic += volume * load(&inc.plastic[c]);
    group.store(&p.volume[k], volume * (1.0 + load(&inc.exx[c]) + load(&inc.eyy[c])));
  });
}

template <GatherParts parts, bool strain_of_first, bool affine>
GatherSums gather_range(Domain& domain, Particles& p, std::size_t begin, std::size_t end,
                        const Settings& set) {
  constexpr Wanted wanted{.v = parts.velocity && !affine,
                          .v_new = parts.velocity || parts.position,
                          .gradient = parts.strain,
                          .of_v = strain_of_first,
                          .affine = parts.velocity && affine};
  const Axis x_axis = domain.x_axis();
  const Axis y_axis = domain.y_axis();
  LaneSums sums;
  Increments inc;
  for (std::size_t first = begin; first < end; first += chunk) {
    const std::size_t count = std::min(chunk, end - first);
    by_fours(0, count, [&](std::size_t c, auto group) {
      const std::size_t k = first + c;
      const Lanes x = group.load(&p.x[k]);
      const Lanes y = group.load(&p.y[k]);
      const Samples q = sample<wanted>(domain.grid, x, y, group.count, x_axis, y_axis);
      if constexpr (parts.velocity) {
        if constexpr (affine)
          take_affine(p, k, group, q);
        else
          take_blend(p, k, group, q, set.flip_share);
      }
      if constexpr (parts.strain)
        take_strain(p, k, group, q, set.dt, c, inc, sums);
      if constexpr (parts.position) {
        group.store(&p.x[k], x + set.dt * q.v_new.x);
        group.store(&p.y[k], y + set.dt * q.v_new.y);
        sums.max_speed2 = larger(q.v_new.x * q.v_new.x + q.v_new.y * q.v_new.y, sums.max_speed2);
      }
    });
    if constexpr (parts.strain)
      strain_chunk(p, first, count, inc, sums);
  }
  return sums.collected();
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
