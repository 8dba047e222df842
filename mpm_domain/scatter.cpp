#include "mpm_domain/scatter.hpp"

namespace tremolo::mpm_domain {

namespace {

/// One particle's contribution to a node with weight s, gradient (gx, gy) and offset (dx, dy) is
///     motion += s (m + mc_x dx + mc_y dy),   force += s weight + gx stress_x + gy stress_y.
struct Contribution {
  Lanes m, mc_x, mc_y;
  Lanes weight, stress_x, stress_y;
};

template <bool affine>
Contribution contribution(const Particles& p, std::size_t k, double gravity) {
  const double m = p.mass[k];
  const double v = p.volume[k];
  Contribution c;
  c.m = Lanes{m, m * p.vx[k], m * p.vy[k], 0.0};
  if constexpr (affine) {
    c.mc_x = Lanes{0.0, m * p.cxx[k], m * p.cyx[k], 0.0};
    c.mc_y = Lanes{0.0, m * p.cxy[k], m * p.cyy[k], 0.0};
  }
  c.weight = Lanes{0.0, -m * gravity, 0.0, 0.0};
  c.stress_x = Lanes{-v * p.sxx[k], -v * p.sxy[k], 0.0, 0.0};
  c.stress_y = Lanes{-v * p.sxy[k], -v * p.syy[k], 0.0, 0.0};
  return c;
}

template <bool motion, bool force, bool affine>
void scatter_range(const Particles& p, std::size_t begin, std::size_t end, Domain& domain) {
  const Axis x_axis = domain.x_axis();
  const Axis y_axis = domain.y_axis();
  const double gravity = domain.spec.gravity;
  Grid& grid = domain.grid;
  for (std::size_t k = begin; k < end; ++k) {
    const Weights wx = gimp_weights(p.x[k], x_axis);
    const Weights wy = gimp_weights(p.y[k], y_axis);
    const Contribution c = contribution<affine>(p, k, gravity);
    NodeSum* row = &grid.sums[grid.index(wx.base, wy.base)];
    for (int j = 0; j < 3; ++j, row += grid.nx)
      for (int i = 0; i < 3; ++i) {
        const double s = wx.s[i] * wy.s[j];
        if constexpr (motion) {
          if constexpr (affine)
            row[i].motion += s * (c.m + wx.d[i] * c.mc_x + wy.d[j] * c.mc_y);
          else
            row[i].motion += s * c.m;
        }
        if constexpr (force)
          row[i].force += s * c.weight + (wx.g[i] * wy.s[j]) * c.stress_x + (wx.s[i] * wy.g[j]) * c.stress_y;
      }
  }
}

template <bool motion, bool force>
void scatter_blocks(Domain& domain) {
  Grid& grid = domain.grid;
  domain.workers.run(static_cast<std::size_t>(grid.ny), [&](std::size_t row) {
    NodeSum* node = &grid.sums[row * static_cast<std::size_t>(grid.nx)];
    for (int i = 0; i < grid.nx; ++i) {
      if constexpr (motion)
        node[i].motion = Lanes{};
      if constexpr (force)
        node[i].force = Lanes{};
    }
  });
  const std::size_t blocks = domain.block_count();
  for (std::size_t colour = 0; colour < 2; ++colour)
    domain.workers.run((blocks + 1 - colour) / 2, [&](std::size_t task) {
      const std::size_t block = 2 * task + colour;
      for (const Particles& p : domain.sets) {
        const std::size_t begin = p.block_start[block];
        const std::size_t end = p.block_start[block + 1];
        if (p.cxx.empty())
          scatter_range<motion, force, false>(p, begin, end, domain);
        else
          scatter_range<motion, force, true>(p, begin, end, domain);
      }
    });
}

} // namespace

void scatter(Domain& domain, ScatterPart part) {
  switch (part) {
  case ScatterPart::motion:
    return scatter_blocks<true, false>(domain);
  case ScatterPart::force:
    return scatter_blocks<false, true>(domain);
  case ScatterPart::both:
    return scatter_blocks<true, true>(domain);
  }
}

} // namespace tremolo::mpm_domain
