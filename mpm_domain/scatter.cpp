#include "mpm_domain/scatter.hpp"

#include "mpm_domain/periodic_sides.hpp"

#include <algorithm>
#include <array>

namespace tremolo::mpm_domain {

namespace {

/// What the particles of one cell add to the nodes that they share, three rows of four: held in registers
/// while they stream through, written to the grid once.
struct SharedSums {
  std::array<Lanes, 3> mass{}, momentum_x{}, momentum_y{}, force_x{}, force_y{};
};

void add_rows(NodeField& field, std::size_t first, std::size_t row, const std::array<Lanes, 3>& sums) {
  for (std::size_t j = 0; j < 3; ++j) {
    double* const nodes = field.data() + first + j * row;
    store(nodes, load(nodes) + sums[j]);
  }
}

template <bool motion, bool force>
void add_to_grid(Grid& grid, std::size_t first, const SharedSums& sums) {
  const auto row = static_cast<std::size_t>(grid.nx);
  if constexpr (motion) {
    add_rows(grid.mass, first, row, sums.mass);
    add_rows(grid.momentum_x, first, row, sums.momentum_x);
    add_rows(grid.momentum_y, first, row, sums.momentum_y);
  }
  if constexpr (force) {
    add_rows(grid.force_x, first, row, sums.force_x);
    add_rows(grid.force_y, first, row, sums.force_y);
  }
}

/// Adds one particle's S m, S m (v + C (x_i - x)) and S m g - V sigma grad S. Lanes run along x: for each row
/// only the factors of y remain.
template <bool motion, bool force, bool affine>
inline void add_particle(const Particles& p, std::size_t k, const Weights& wx, const Weights& wy,
                         const Domain& domain, SharedSums& sums) {
  const Lanes mass = p.mass[k] * wx.s;
  Lanes px = p.vx[k] * mass;
  Lanes py = p.vy[k] * mass;
  Lanes px_dy{};
  Lanes py_dy{};
  Lanes dy{};
  if constexpr (motion && affine) {
    const Lanes dx = offsets(wx, p.x[k], domain.x_axis());
    dy = offsets(wy, p.y[k], domain.y_axis());
    px += p.cxx[k] * dx * mass;
    py += p.cyx[k] * dx * mass;
    px_dy = p.cxy[k] * mass;
    py_dy = p.cyy[k] * mass;
  }
  const double v = -p.volume[k];
  const Lanes fx_s = v * p.sxx[k] * wx.g;
  const Lanes fx_g = v * p.sxy[k] * wx.s;
  const Lanes fy_s = v * p.sxy[k] * wx.g - domain.spec.gravity * mass;
  const Lanes fy_g = v * p.syy[k] * wx.s;
  for (std::size_t j = 0; j < 3; ++j) {
    const double s = wy.s[j];
    const double g = wy.g[j];
    if constexpr (motion) {
      sums.mass[j] += s * mass;
      if constexpr (affine) {
        sums.momentum_x[j] += s * (px + dy[j] * px_dy);
        sums.momentum_y[j] += s * (py + dy[j] * py_dy);
      } else {
        sums.momentum_x[j] += s * px;
        sums.momentum_y[j] += s * py;
      }
    }
    if constexpr (force) {
      sums.force_x[j] += s * fx_s + g * fx_g;
      sums.force_y[j] += s * fy_s + g * fy_g;
    }
  }
}

/// Flattened: the sums leave the registers if anything that touches them is a call.
template <bool motion, bool force, bool affine>
[[gnu::flatten]] void scatter_range(const Particles& p, std::size_t begin, std::size_t end, Domain& domain) {
  const Axis x_axis = domain.x_axis();
  const Axis y_axis = domain.y_axis();
  Grid& grid = domain.grid;
  SharedSums sums;
  std::size_t shared = 0; // first node of the sums
  for (std::size_t k = begin; k < end; ++k) {
    const Weights wx = cell_weights(p.x[k], x_axis);
    const Weights wy = gimp_weights(p.y[k], y_axis);
    const std::size_t first = grid.index(wx.base, wy.base);
    if (first != shared) {
      if (k > begin)
        add_to_grid<motion, force>(grid, shared, sums);
      sums = {};
      shared = first;
    }
    add_particle<motion, force, affine>(p, k, wx, wy, domain, sums);
  }
  if (begin < end)
    add_to_grid<motion, force>(grid, shared, sums);
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
