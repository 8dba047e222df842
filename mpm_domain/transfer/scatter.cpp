#include "mpm_domain/transfer/scatter.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/stencil.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// What a pass scatters of the particles' motion.
enum class Motion { none, momentum, mass_and_momentum };

/// Particles whose weights are held at a time, in the first-level cache.
constexpr std::size_t chunk = 64;

/// Weights of a chunk of particles: of x a row of four nodes each, of y one number per row.
template <std::size_t rows>
struct ChunkWeights {
  std::array<std::int32_t, chunk> first; ///< node
  std::array<Lanes, chunk> xs, xg;
  std::array<std::array<double, chunk>, rows> ys, yg;
  std::array<double, chunk> xi, eta;      ///< cells above node 1 of a row, above row 0
  std::array<double, chunk> per_x, per_y; ///< of D^-1, 1/m2
};

template <bool force, bool affine, typename Boxes, typename Group>
[[gnu::always_inline]] inline void
take_weights(const Particles& p, std::size_t k, std::size_t c, Group group, const Lattice& lattice,
             const Axis& x_axis, const Axis& y_axis, const Boxes& boxes, ChunkWeights<Boxes::rows>& w) {
  const auto& own = boxes.of(k, group);
  const Stencils at(group.load(&p.x[k]), group.load(&p.y[k]), x_axis, y_axis, own);
  const std::array<std::int32_t, 4> first = at.first_nodes(lattice);
  std::copy(first.begin(), first.end(), &w.first[c]);
  const auto wx = own.along_x(at.xi, x_axis);
  const auto wy = own.along_y(at.eta, y_axis);
  const std::array<Lanes, 4> s = transposed(wx.s);
  for (std::size_t i = 0; i < 4; ++i)
    w.xs[c + i] = s[i];
  for (std::size_t j = 0; j < Boxes::rows; ++j)
    store(&w.ys[j][c], wy.s[j]);
  if constexpr (force) {
    const std::array<Lanes, 4> g = transposed(wx.g);
    for (std::size_t i = 0; i < 4; ++i)
      w.xg[c + i] = g[i];
    for (std::size_t j = 0; j < Boxes::rows; ++j)
      store(&w.yg[j][c], wy.g[j]);
  }
  if constexpr (affine) {
    store(&w.xi[c], at.xi);
    store(&w.eta[c], at.eta);
    const Lanes per_both = 1.0 / (wx.second_moment * wy.second_moment); // a division costs more than all else
    store(&w.per_x[c], wy.second_moment * per_both);
    store(&w.per_y[c], wx.second_moment * per_both);
  }
}

/// Arrays of particles and nodes by their first element: a pointer in a vector would be read anew after every
/// store.
struct Arrays {
  const double *mass, *volume, *vx, *vy, *bxx, *bxy, *byx, *byy, *sxx, *syy, *sxy;
  double *node_mass, *momentum_x, *momentum_y, *force_x, *force_y;
  std::ptrdiff_t row; ///< nodes

  /// From particle `first` on.
  Arrays(const Particles& p, std::size_t first, const Lattice& lattice, Grid& grid)
      : mass(&p.mass[first]), volume(&p.volume[first]), vx(&p.vx[first]), vy(&p.vy[first]),
        bxx(at(p.bxx, first)), bxy(at(p.bxy, first)), byx(at(p.byx, first)), byy(at(p.byy, first)),
        sxx(&p.sxx[first]), syy(&p.syy[first]), sxy(&p.sxy[first]), node_mass(grid.mass.data()),
        momentum_x(grid.momentum_x.data()), momentum_y(grid.momentum_y.data()), force_x(grid.force_x.data()),
        force_y(grid.force_y.data()), row(lattice.nx) {}

private:
  /// Affine velocities need not be there.
  static const double* at(const std::vector<double>& column, std::size_t first) {
    return column.empty() ? nullptr : &column[first];
  }
};

template <std::size_t rows>
using Rows = std::array<Lanes, rows>;

template <std::size_t rows>
[[gnu::always_inline]] inline void add_rows(double* nodes, std::ptrdiff_t row, const Rows<rows>& sums) {
  for (std::size_t j = 0; j < rows; ++j, nodes += row)
    store(nodes, load(nodes) + sums[j]);
}

/// What the particles of one cell add to the nodes that they share, rows of four: held in registers while
/// they stream through, written to the grid once. Motion and force go one after the other: together they are
/// more than the registers hold.
template <Motion motion, std::size_t rows>
struct MotionSums {
  Rows<rows> mass{}, momentum_x{}, momentum_y{};

  /// S m and S m (v + C (x_i - x)), C = B D^-1. Lanes run along x: for each row only the factor of y remains.
  template <bool affine>
  [[gnu::always_inline]] void add(const Arrays& a, const ChunkWeights<rows>& w, std::size_t c, double h) {
    const Lanes m = a.mass[c] * w.xs[c];
    Lanes vx = all(a.vx[c]);
    Lanes vy = all(a.vy[c]);
    Lanes row_x{}; // from one row to the next
    Lanes row_y{};
    if constexpr (affine) {
      constexpr Lanes node = {-1.0, 0.0, 1.0, 2.0};
      const Lanes dx = h * (node - w.xi[c]);
      const double dy = -h * w.eta[c];
      const double cxy = a.bxy[c] * w.per_y[c];
      const double cyy = a.byy[c] * w.per_y[c];
      vx += a.bxx[c] * w.per_x[c] * dx + cxy * dy;
      vy += a.byx[c] * w.per_x[c] * dx + cyy * dy;
      row_x = cxy * h * m;
      row_y = cyy * h * m;
    }
    Lanes px = m * vx;
    Lanes py = m * vy;
    for (std::size_t j = 0; j < rows; ++j) {
      const double s = w.ys[j][c];
      if constexpr (motion == Motion::mass_and_momentum)
        mass[j] += s * m;
      momentum_x[j] += s * px;
      momentum_y[j] += s * py;
      if constexpr (affine) {
        px += row_x;
        py += row_y;
      }
    }
  }

  [[gnu::always_inline]] void add_to(const Arrays& a, std::ptrdiff_t first) const {
    if constexpr (motion == Motion::mass_and_momentum)
      add_rows(a.node_mass + first, a.row, mass);
    add_rows(a.momentum_x + first, a.row, momentum_x);
    add_rows(a.momentum_y + first, a.row, momentum_y);
  }
};

template <std::size_t rows>
struct ForceSums {
  Rows<rows> force_x{}, force_y{};

  /// S m g - V sigma grad S
  [[gnu::always_inline]] void add(const Arrays& a, const ChunkWeights<rows>& w, std::size_t c,
                                  const Lanes& gravity) {
    const Lanes vs = a.volume[c] * w.xs[c];
    const Lanes vg = a.volume[c] * w.xg[c];
    const Lanes fx_s = a.sxx[c] * vg;
    const Lanes fx_g = a.sxy[c] * vs;
    const Lanes fy_s = a.sxy[c] * vg + gravity * (a.mass[c] * w.xs[c]);
    const Lanes fy_g = a.syy[c] * vs;
    for (std::size_t j = 0; j < rows; ++j) {
      const double s = w.ys[j][c];
      const double g = w.yg[j][c];
      force_x[j] -= s * fx_s;
      force_y[j] -= s * fy_s;
      force_x[j] -= g * fx_g;
      force_y[j] -= g * fy_g;
    }
  }

  [[gnu::always_inline]] void add_to(const Arrays& a, std::ptrdiff_t first) const {
    add_rows(a.force_x + first, a.row, force_x);
    add_rows(a.force_y + first, a.row, force_y);
  }
};

/// Sums of a chunk, cell by cell; add(sums, c) adds particle c of it.
template <typename Sums, std::size_t rows, typename Add>
[[gnu::always_inline]] inline void stream(const ChunkWeights<rows>& w, std::size_t count,
                                          const Arrays& arrays, const Add& add) {
  for (std::size_t c = 0; c < count;) {
    const std::int32_t shared = w.first[c];
    Sums sums;
    do
      add(sums, c++);
    while (c < count && w.first[c] == shared);
    sums.add_to(arrays, shared);
  }
}

/// Flattened: the sums leave the registers if anything that touches them is a call.
template <Motion motion, bool force, bool affine, typename Boxes>
[[gnu::flatten]] void scatter_range(const Particles& p, std::size_t begin, std::size_t end,
                                    const Lattice& lattice, Grid& grid, double gravity) {
  using Moving = MotionSums<motion, Boxes::rows>;
  using Pulling = ForceSums<Boxes::rows>;
  const Axis x_axis(lattice.x0, lattice.h);
  const Axis y_axis(lattice.y0, lattice.h);
  const Boxes boxes(p, lattice, x_axis);
  const Lanes g = all(gravity);
  ChunkWeights<Boxes::rows> w;
  for (std::size_t k = begin; k < end; k += chunk) {
    const std::size_t count = std::min(chunk, end - k);
    by_fours(0, count, [&](std::size_t c, auto group) {
      take_weights<force, motion != Motion::none && affine>(p, k + c, c, group, lattice, x_axis, y_axis,
                                                            boxes, w);
    });
    const Arrays arrays(p, k, lattice, grid);
    if constexpr (motion != Motion::none)
      stream<Moving>(w, count, arrays, [&](Moving& sums, std::size_t c) {
        sums.template add<affine>(arrays, w, c, lattice.h);
      });
    if constexpr (force)
      stream<Pulling>(w, count, arrays, [&](Pulling& sums, std::size_t c) { sums.add(arrays, w, c, g); });
  }
}

/// The boxes and affine velocities that a set has.
template <Motion motion, bool force>
void scatter_set(const Particles& p, std::size_t block, const Lattice& lattice, Domain& domain) {
  const auto scatter_as = [&]<bool affine, typename Boxes>() {
    scatter_range<motion, force, affine, Boxes>(p, p.block_start[block], p.block_start[block + 1], lattice,
                                                domain.grid, domain.spec.gravity);
  };
  if (p.has_own_boxes())
    p.traits.affine ? scatter_as.template operator()<true, OwnRectangles>()
                    : scatter_as.template operator()<false, OwnRectangles>();
  else if (p.traits.affine)
    scatter_as.template operator()<true, OneSquare>();
  else
    scatter_as.template operator()<false, OneSquare>();
}

[[gnu::always_inline]] inline void add_at(NodeField& field, const std::array<std::uint32_t, 4>& nodes,
                                          const Lanes& values) {
  for (std::size_t lane = 0; lane < 4; ++lane)
    field[nodes[lane]] += values[lane];
}

/// The same for particles that touch several lattices, four nodes at a time.
template <Motion motion, bool force, bool affine>
void scatter_across(const Particles& p, const AcrossWeights& weights, const BasisCells& cells, Grid& grid,
                    double gravity) {
  for (std::size_t k = weights.first(); k < weights.end(); ++k) {
    const double m = p.mass[k];
    const double v = p.volume[k];
    double cxx = 0.0, cxy = 0.0, cyx = 0.0, cyy = 0.0; // C = B D^-1
    if constexpr (motion != Motion::none && affine) {
      const InverseMoments& per = weights.per_moments(k);
      cxx = p.bxx[k] * per.x;
      cxy = p.bxy[k] * per.y;
      cyx = p.byx[k] * per.x;
      cyy = p.byy[k] * per.y;
    }
    for (const FourWeights& w : weights.of(k)) {
      const Lanes mass = m * w.s;
      if constexpr (motion != Motion::none) {
        Lanes vx = all(p.vx[k]);
        Lanes vy = all(p.vy[k]);
        if constexpr (affine) {
          const FourNodes& nodes = cells.four(w.four);
          const Lanes dx = nodes.x - p.x[k];
          const Lanes dy = nodes.y - p.y[k];
          vx += cxx * dx + cxy * dy;
          vy += cyx * dx + cyy * dy;
        }
        if constexpr (motion == Motion::mass_and_momentum)
          add_at(grid.mass, w.node, mass);
        add_at(grid.momentum_x, w.node, mass * vx);
        add_at(grid.momentum_y, w.node, mass * vy);
      }
      if constexpr (force) {
        add_at(grid.force_x, w.node, -v * (p.sxx[k] * w.gx + p.sxy[k] * w.gy));
        add_at(grid.force_y, w.node, -v * (p.sxy[k] * w.gx + p.syy[k] * w.gy) - gravity * mass);
      }
    }
  }
}

template <Motion motion, bool force>
void add_clock(Domain& domain, int clock) {
  const std::size_t blocks = domain.blocks_per_clock();
  const std::size_t first = static_cast<std::size_t>(clock) * blocks;
  for (std::size_t colour = 0; colour < 2; ++colour)
    domain.workers.run((blocks + 1 - colour) / 2, [&](std::size_t task) {
      const std::size_t block = first + 2 * task + colour;
      const Lattice& lattice = domain.lattice(domain.lattice_of_block(block));
      for (const Particles& p : domain.sets)
        scatter_set<motion, force>(p, block, lattice, domain);
    });
  if (domain.mesh)
    for (std::size_t s = 0; s < domain.sets.size(); ++s) {
      const Particles& p = domain.sets[s];
      const auto scatter_as =
          p.traits.affine ? scatter_across<motion, force, true> : scatter_across<motion, force, false>;
      scatter_as(p, domain.across_of(s, clock), domain.basis_cells, domain.grid, domain.spec.gravity);
    }
}

/// act(group) for the groups of node fields that a part sums up.
template <typename Act>
void for_groups(ScatterPart part, const Act& act) {
  if (part == ScatterPart::motion || part == ScatterPart::both)
    act(NodeGroup::mass);
  if (part != ScatterPart::force)
    act(NodeGroup::momentum);
  if (part == ScatterPart::force || part == ScatterPart::both)
    act(NodeGroup::force);
}

} // namespace

void clear(Domain& domain, ScatterPart part, std::span<const NodeRange> nodes) {
  std::vector<NodeField*> fields;
  for_groups(part, [&](NodeGroup group) {
    for_group(domain.grid, group, [&](NodeField& field) { fields.push_back(&field); });
  });
  domain.workers.run(nodes.size(), [&](std::size_t row) {
    for (NodeField* field : fields)
      std::fill(field->data() + nodes[row].begin, field->data() + nodes[row].end, 0.0);
  });
}

void add_particles(Domain& domain, ScatterPart part, int clock) {
  switch (part) {
  case ScatterPart::motion:
    return add_clock<Motion::mass_and_momentum, false>(domain, clock);
  case ScatterPart::momentum:
    return add_clock<Motion::momentum, false>(domain, clock);
  case ScatterPart::force:
    return add_clock<Motion::none, true>(domain, clock);
  case ScatterPart::both:
    return add_clock<Motion::mass_and_momentum, true>(domain, clock);
  }
}

void fold(Domain& domain, ScatterPart part, std::span<const std::size_t> rows) {
  for_groups(part, [&](NodeGroup group) { fold(domain, group, rows); });
}

void scatter(Domain& domain, ScatterPart part) {
  clear(domain, part, domain.soil_rows);
  for (int clock = 0; clock < domain.clocks.count(); ++clock)
    add_particles(domain, part, clock);
  for_groups(part, [&](NodeGroup group) { fold(domain, group); });
}

} // namespace tremolo::mpm_domain
