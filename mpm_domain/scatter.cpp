#include "mpm_domain/scatter.hpp"

#include "mpm_domain/periodic_sides.hpp"
#include "mpm_domain/stencil.hpp"

#include <algorithm>
#include <array>

namespace tremolo::mpm_domain {

namespace {

/// Particles whose weights are held at a time, in the first-level cache.
constexpr std::size_t chunk = 64;

/// Weights of a chunk of particles: of x a row of four nodes each, of y one number per row.
struct ChunkWeights {
  std::array<std::int32_t, chunk> first; ///< node
  std::array<Lanes, chunk> xs, xg;
  std::array<std::array<double, chunk>, 3> ys, yg;
  std::array<double, chunk> xi, eta; ///< cells above node 1 of a row, above row 0
};

template <bool force, bool affine, typename Group>
[[gnu::always_inline]] inline void take_weights(const Particles& p, std::size_t k, std::size_t c, Group group,
                                                const Grid& grid, const Axis& x_axis, const Axis& y_axis,
                                                ChunkWeights& w) {
  const Stencils at(group.load(&p.x[k]), group.load(&p.y[k]), x_axis, y_axis);
  const std::array<std::int32_t, 4> first = at.first_nodes(grid);
  std::copy(first.begin(), first.end(), &w.first[c]);
  const CellWeights<Lanes> wx(at.xi, x_axis);
  const RowWeights<Lanes> wy(at.eta, y_axis);
  const std::array<Lanes, 4> s = transposed(wx.s);
  std::copy(s.begin(), s.end(), &w.xs[c]);
  for (std::size_t j = 0; j < 3; ++j)
    store(&w.ys[j][c], wy.s[j]);
  if constexpr (force) {
    const std::array<Lanes, 4> g = transposed(wx.g);
    std::copy(g.begin(), g.end(), &w.xg[c]);
    for (std::size_t j = 0; j < 3; ++j)
      store(&w.yg[j][c], wy.g[j]);
  }
  if constexpr (affine) {
    store(&w.xi[c], at.xi);
    store(&w.eta[c], at.eta);
  }
}

using Rows = std::array<Lanes, 3>;

void add_rows(NodeField& field, std::size_t first, std::size_t row, const Rows& sums) {
  for (std::size_t j = 0; j < 3; ++j) {
    double* const nodes = field.data() + first + j * row;
    store(nodes, load(nodes) + sums[j]);
  }
}

/// What the particles of one cell add to the nodes that they share, three rows of four: held in registers
/// while they stream through, written to the grid once. Motion and force go one after the other: together
/// they are more than the registers hold.
struct MotionSums {
  Rows mass{}, momentum_x{}, momentum_y{};

  /// S m and S m (v + C (x_i - x)). Lanes run along x: for each row only the factor of y remains.
  template <bool affine>
  [[gnu::always_inline]] void add(const Particles& p, std::size_t k, const ChunkWeights& w, std::size_t c,
                                  const Axis& x_axis, const Axis& y_axis) {
    const Lanes m = p.mass[k] * w.xs[c];
    Lanes vx = all(p.vx[k]);
    Lanes vy = all(p.vy[k]);
    Lanes row_x{}; // from one row to the next
    Lanes row_y{};
    if constexpr (affine) {
      constexpr Lanes node = {-1.0, 0.0, 1.0, 2.0};
      const Lanes dx = x_axis.h * (node - w.xi[c]);
      const double dy = -y_axis.h * w.eta[c];
      vx += p.cxx[k] * dx + p.cxy[k] * dy;
      vy += p.cyx[k] * dx + p.cyy[k] * dy;
      row_x = p.cxy[k] * y_axis.h * m;
      row_y = p.cyy[k] * y_axis.h * m;
    }
    Lanes px = m * vx;
    Lanes py = m * vy;
    for (std::size_t j = 0; j < 3; ++j) {
      const double s = w.ys[j][c];
      mass[j] += s * m;
      momentum_x[j] += s * px;
      momentum_y[j] += s * py;
      if constexpr (affine) {
        px += row_x;
        py += row_y;
      }
    }
  }

  [[gnu::always_inline]] void add_to(Grid& grid, std::size_t first) const {
    const auto row = static_cast<std::size_t>(grid.nx);
    add_rows(grid.mass, first, row, mass);
    add_rows(grid.momentum_x, first, row, momentum_x);
    add_rows(grid.momentum_y, first, row, momentum_y);
  }
};

struct ForceSums {
  Rows force_x{}, force_y{};

  /// S m g - V sigma grad S
  [[gnu::always_inline]] void add(const Particles& p, std::size_t k, const ChunkWeights& w, std::size_t c,
                                  double gravity) {
    const Lanes vs = -p.volume[k] * w.xs[c];
    const Lanes vg = -p.volume[k] * w.xg[c];
    const Lanes fx_s = p.sxx[k] * vg;
    const Lanes fx_g = p.sxy[k] * vs;
    const Lanes fy_s = p.sxy[k] * vg - gravity * p.mass[k] * w.xs[c];
    const Lanes fy_g = p.syy[k] * vs;
    for (std::size_t j = 0; j < 3; ++j) {
      const double s = w.ys[j][c];
      const double g = w.yg[j][c];
      force_x[j] += s * fx_s + g * fx_g;
      force_y[j] += s * fy_s + g * fy_g;
    }
  }

  [[gnu::always_inline]] void add_to(Grid& grid, std::size_t first) const {
    const auto row = static_cast<std::size_t>(grid.nx);
    add_rows(grid.force_x, first, row, force_x);
    add_rows(grid.force_y, first, row, force_y);
  }
};

/// Sums of a chunk, cell by cell; add(sums, c) adds particle c of it.
template <typename Sums, typename Add>
[[gnu::always_inline]] inline void stream(const ChunkWeights& w, std::size_t count, Grid& grid,
                                          const Add& add) {
  for (std::size_t c = 0; c < count;) {
    const std::int32_t shared = w.first[c];
    Sums sums;
    do
      add(sums, c++);
    while (c < count && w.first[c] == shared);
    sums.add_to(grid, static_cast<std::size_t>(shared));
  }
}

/// Flattened: the sums leave the registers if anything that touches them is a call.
template <bool motion, bool force, bool affine>
[[gnu::flatten]] void scatter_range(const Particles& p, std::size_t begin, std::size_t end, Domain& domain) {
  const Axis x_axis = domain.x_axis();
  const Axis y_axis = domain.y_axis();
  const double gravity = domain.spec.gravity;
  Grid& grid = domain.grid;
  ChunkWeights w;
  for (std::size_t k = begin; k < end; k += chunk) {
    const std::size_t count = std::min(chunk, end - k);
    by_fours(0, count, [&](std::size_t c, auto group) {
      take_weights<force, motion && affine>(p, k + c, c, group, grid, x_axis, y_axis, w);
    });
    if constexpr (motion)
      stream<MotionSums>(w, count, grid, [&](MotionSums& sums, std::size_t c) {
        sums.add<affine>(p, k + c, w, c, x_axis, y_axis);
      });
    if constexpr (force)
      stream<ForceSums>(w, count, grid,
                        [&](ForceSums& sums, std::size_t c) { sums.add(p, k + c, w, c, gravity); });
  }
}

template <bool motion, bool force>
void clear_row(Grid& grid, std::size_t row) {
  const auto width = static_cast<std::ptrdiff_t>(grid.nx);
  const auto clear = [&](NodeField& field) {
    const auto first = field.begin() + static_cast<std::ptrdiff_t>(row) * width;
    std::fill(first, first + width, 0.0);
  };
  if constexpr (motion)
    for (NodeField* field : {&grid.mass, &grid.momentum_x, &grid.momentum_y})
      clear(*field);
  if constexpr (force)
    for (NodeField* field : {&grid.force_x, &grid.force_y, &grid.dashpot_x, &grid.dashpot_y})
      clear(*field);
}

template <bool motion, bool force>
void scatter_blocks(Domain& domain) {
  domain.workers.run(static_cast<std::size_t>(domain.grid.ny),
                     [&](std::size_t row) { clear_row<motion, force>(domain.grid, row); });
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
  if (domain.spec.periodic_sides) {
    if constexpr (motion)
      fold_motion(domain);
    if constexpr (force)
      fold_forces(domain);
  }
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
