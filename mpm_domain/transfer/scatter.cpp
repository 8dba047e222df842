#include "mpm_domain/transfer/scatter.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/stencil.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// Which part of the particles' motion a pass scatters.
enum class Motion { none, momentum, mass_and_momentum };

/// Particles whose weights are held at a time, in the first-level cache.
constexpr std::size_t chunk = 64;

/// Weights of a chunk of particles: along x those of four nodes, along y one number per row.
template <std::size_t rows>
struct ChunkWeights {
  std::array<std::int32_t, chunk> first; ///< first node of the stencil, in the window
  std::array<Lanes, chunk> xs, xg;
  std::array<std::array<double, chunk>, rows> ys, yg;
  std::array<double, chunk> xi, eta;      ///< cells above node 1 of a row, above row 0
  std::array<double, chunk> per_x, per_y; ///< diagonal of D^-1, 1/m2
};

/// The least and the largest first row among the particles seen so far, for each of the four lanes.
struct FirstRows {
  static constexpr double far = std::numeric_limits<double>::infinity();
  Lanes least = all(far);
  Lanes last = all(-far);

  template <typename Group>
  [[gnu::always_inline]] void see(const Lanes& rows, Group group) {
    least = group.present(smaller(rows, least), least);
    last = group.present(larger(rows, last), last);
  }

  /// The rows that the stencils of these particles cover.
  /// @param rows  of one stencil
  RowRange stencils(std::size_t rows) const {
    return {static_cast<int>(std::min(std::min(least[0], least[1]), std::min(least[2], least[3]))),
            static_cast<int>(std::max(std::max(last[0], last[1]), std::max(last[2], last[3]))) +
                static_cast<int>(rows)};
  }
};

template <bool force, bool affine, typename Boxes, typename Group>
[[gnu::always_inline]] inline void take_weights(const Particles& p, std::size_t k, std::size_t c, Group group,
                                                const NodeArray& nodes, const Axis& x_axis,
                                                const Axis& y_axis, const Boxes& boxes,
                                                ChunkWeights<Boxes::rows>& w, FirstRows& seen) {
  const auto& own = boxes.of(k, group);
  const Stencils at(group.load(&p.x[k]), group.load(&p.y[k]), x_axis, y_axis, own);
  seen.see(at.y0, group);
  const std::array<std::int32_t, 4> first = at.first_nodes(nodes);
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

/// Stress of a chunk of particles, Pa.
struct ChunkStress {
  std::array<double, chunk> xx, yy, xy;
};

/// The arrays of a chunk of particles and of a window's sums, as pointers to their first element. The
/// compiler would load the pointer inside a std::vector again after every store.
struct Arrays {
  const double *mass, *volume, *vx, *vy, *bxx, *bxy, *byx, *byy, *sxx, *syy, *sxy;
  double* sums; ///< [field of particle_sums][row][column]

  /// @param first  particle that the chunk begins with
  Arrays(const Particles& p, std::size_t first, double* window)
      : mass(&p.mass[first]), volume(&p.volume[first]), vx(&p.vx[first]), vy(&p.vy[first]),
        bxx(at(p.bxx, first)), bxy(at(p.bxy, first)), byx(at(p.byx, first)), byy(at(p.byy, first)),
        sxx(&p.sxx[first]), syy(&p.syy[first]), sxy(&p.sxy[first]), sums(window) {}

  double* of(Sum field) const { return sums + static_cast<std::size_t>(field) * window_nodes; }

  /// Lets forces see the stress of the law and that of viscous damping.
  void add_viscous(const Particles& p, std::size_t first, std::size_t count, ChunkStress& sum) {
    by_fours(0, count, [&](std::size_t c, auto group) {
      const auto add = [&](std::vector<double> ParticleFields::*stress,
                           std::vector<double> ParticleFields::*viscous, std::array<double, chunk>& to) {
        group.store(&to[c], group.load(&(p.*stress)[first + c]) + group.load(&(p.*viscous)[first + c]));
      };
      add(&ParticleFields::sxx, &ParticleFields::viscous_xx, sum.xx);
      add(&ParticleFields::syy, &ParticleFields::viscous_yy, sum.yy);
      add(&ParticleFields::sxy, &ParticleFields::viscous_xy, sum.xy);
    });
    sxx = sum.xx.data();
    syy = sum.yy.data();
    sxy = sum.xy.data();
  }

private:
  /// A set without affine velocities has no such arrays.
  static const double* at(const std::vector<double>& column, std::size_t first) {
    return column.empty() ? nullptr : &column[first];
  }
};

template <std::size_t rows>
using Rows = std::array<Lanes, rows>;

template <std::size_t rows>
[[gnu::always_inline]] inline void add_rows(double* nodes, const Rows<rows>& sums) {
  for (std::size_t j = 0; j < rows; ++j, nodes += window_columns)
    store(nodes, load(nodes) + sums[j]);
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
/// summed up one after the other, since the registers do not hold both.
template <Motion motion, std::size_t rows>
struct MotionSums {
  Rows<rows> mass, momentum_x, momentum_y; ///< not set until the first particle

  /// S m and S m (v + C (x_i - x)), C = B D^-1. Lanes run along x: for each row only the factor of y remains.
  template <bool affine, bool first>
  [[gnu::always_inline]] void add(const Arrays& a, const ChunkWeights<rows>& w, std::size_t c, double h) {
    const Lanes m = a.mass[c] * w.xs[c];
    Lanes vx = all(a.vx[c]);
    Lanes vy = all(a.vy[c]);
    Lanes row_x{}; // increment of momentum from one row to the next
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
        add_to_row<first>(mass[j], s * m);
      add_to_row<first>(momentum_x[j], s * px);
      add_to_row<first>(momentum_y[j], s * py);
      if constexpr (affine) {
        px += row_x;
        py += row_y;
      }
    }
  }

  [[gnu::always_inline]] void add_to(const Arrays& a, std::ptrdiff_t first) const {
    if constexpr (motion == Motion::mass_and_momentum)
      add_rows(a.of(Sum::mass) + first, mass);
    add_rows(a.of(Sum::momentum_x) + first, momentum_x);
    add_rows(a.of(Sum::momentum_y) + first, momentum_y);
  }
};

template <std::size_t rows>
struct ForceSums {
  Rows<rows> force_x, force_y;

  /// S m g - V sigma grad S
  template <bool first>
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
      add_to_row<first>(force_x[j], -(s * fx_s));
      add_to_row<first>(force_y[j], -(s * fy_s));
      force_x[j] -= g * fx_g;
      force_y[j] -= g * fy_g;
    }
  }

  [[gnu::always_inline]] void add_to(const Arrays& a, std::ptrdiff_t first) const {
    add_rows(a.of(Sum::force_x) + first, force_x);
    add_rows(a.of(Sum::force_y) + first, force_y);
  }
};

/// Adds up a chunk cell by cell. add(sums, c, is_first) adds the chunk's particle c to the sums of its cell.
template <typename Sums, std::size_t rows, typename Add>
[[gnu::always_inline]] inline void stream(const ChunkWeights<rows>& w, std::size_t count,
                                          const Arrays& arrays, const Add& add) {
  for (std::size_t c = 0; c < count;) {
    const std::int32_t shared = w.first[c];
    Sums sums;
    add(sums, c++, std::true_type{});
    while (c < count && w.first[c] == shared)
      add(sums, c++, std::false_type{});
    sums.add_to(arrays, shared);
  }
}

/// All calls in this function are inlined (`flatten`): a call would push the sums out of the registers.
/// @returns the rows of the lattice that the particles touch
template <Motion motion, bool force, bool affine, typename Boxes>
[[gnu::flatten]] RowRange scatter_range(const Particles& p, const ParticleRange& range,
                                        const Lattice& lattice, const NodeArray& nodes, double* window,
                                        double gravity) {
  using Moving = MotionSums<motion, Boxes::rows>;
  using Pulling = ForceSums<Boxes::rows>;
  const Axis x_axis(lattice.x0, lattice.h);
  const Axis y_axis(lattice.y0, lattice.h);
  const Boxes boxes(p, lattice, x_axis);
  const Lanes g = all(gravity);
  ChunkWeights<Boxes::rows> w;
  FirstRows seen;
  ChunkStress damped_stress; // only of soil with viscous damping
  for (std::size_t k = range.begin; k < range.end; k += chunk) {
    const std::size_t count = std::min(chunk, range.end - k);
    by_fours(0, count, [&](std::size_t c, auto group) {
      take_weights<force, motion != Motion::none && affine>(p, k + c, c, group, nodes, x_axis, y_axis, boxes,
                                                            w, seen);
    });
    Arrays arrays(p, k, window);
    if constexpr (force)
      if (p.traits.damped)
        arrays.add_viscous(p, k, count, damped_stress);
    if constexpr (motion != Motion::none)
      stream<Moving>(w, count, arrays, [&](Moving& sums, std::size_t c, auto is_first) {
        sums.template add<affine, is_first>(arrays, w, c, lattice.h);
      });
    if constexpr (force)
      stream<Pulling>(w, count, arrays, [&](Pulling& sums, std::size_t c, auto is_first) {
        sums.template add<is_first>(arrays, w, c, g);
      });
  }
  return seen.stencils(Boxes::rows);
}

/// Scatters the particles of a set in a tile, by the boxes and affine velocities that the set has.
/// @returns the rows of the lattice that they touch
template <Motion motion, bool force>
RowRange scatter_set(const Domain& domain, const Particles& p, int clock, std::size_t tile, double* window) {
  const ParticleRange range = p.in_block(domain.block(clock, tile));
  const Lattice& lattice = domain.tiles.lattice(domain.tiles.level_of(tile));
  const NodeArray nodes(domain.tiles.window(tile));
  const auto scatter_as = [&]<bool affine, typename Boxes>() {
    return scatter_range<motion, force, affine, Boxes>(p, range, lattice, nodes, window, domain.spec.gravity);
  };
  if (range.begin == range.end)
    return {};
  if (p.has_own_boxes())
    return p.traits.affine ? scatter_as.template operator()<true, OwnRectangles>()
                           : scatter_as.template operator()<false, OwnRectangles>();
  return p.traits.affine ? scatter_as.template operator()<true, OneSquare>()
                         : scatter_as.template operator()<false, OneSquare>();
}

/// The fields of particle_sums that a pass sums up.
constexpr SumRange fields_of(Motion motion, bool force) {
  return {motion == Motion::mass_and_momentum ? 0U : motion == Motion::momentum ? 1U : 3U, force ? 5U : 3U};
}

/// Adds up the contributions of a tile's particles that touch several lattices, four nodes at a time.
template <Motion motion, bool force, bool affine, bool damped>
void scatter_across(const Particles& p, AcrossTile& tile, const BasisCells& cells, double gravity) {
  const std::size_t field = 4 * tile.weights.fours().size(); // length of one field in `tile.sums`
  constexpr SumRange fields = fields_of(motion, force);
  std::fill(tile.sums.data() + fields.first * field, tile.sums.data() + fields.end * field, 0.0);
  for (std::size_t k = tile.weights.first(); k < tile.weights.end(); ++k) {
    const double m = p.mass[k];
    const double v = p.volume[k];
    double sxx = p.sxx[k];
    double syy = p.syy[k];
    double sxy = p.sxy[k];
    if constexpr (force && damped) {
      sxx += p.viscous_xx[k];
      syy += p.viscous_yy[k];
      sxy += p.viscous_xy[k];
    }
    double cxx = 0.0, cxy = 0.0, cyx = 0.0, cyy = 0.0; // C = B D^-1
    if constexpr (motion != Motion::none && affine) {
      const InverseMoments& per = tile.weights.per_moments(k);
      cxx = p.bxx[k] * per.x;
      cxy = p.bxy[k] * per.y;
      cyx = p.byx[k] * per.x;
      cyy = p.byy[k] * per.y;
    }
    for (const FourWeights& w : tile.weights.of(k)) {
      const Lanes mass = m * w.s;
      const auto add = [&](Sum sum, const Lanes& values) {
        double* to = &tile.sums[static_cast<std::size_t>(sum) * field + 4 * w.place];
        store(to, load(to) + values);
      };
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
          add(Sum::mass, mass);
        add(Sum::momentum_x, mass * vx);
        add(Sum::momentum_y, mass * vy);
      }
      if constexpr (force) {
        add(Sum::force_x, -v * (sxx * w.gx + sxy * w.gy));
        add(Sum::force_y, -v * (sxy * w.gx + syy * w.gy) - gravity * mass);
      }
    }
  }
}

/// Adds the sums of particles across lattices to the nodes, tile by tile. Each field is one task, so the
/// order of the tiles is the same for any number of threads.
void add_across(Domain& domain, std::span<const AcrossTile> tiles, SumRange fields) {
  domain.workers.run(fields.end - fields.first, [&](std::size_t task) {
    const std::size_t f = fields.first + task;
    NodeField& field = domain.grid.*particle_sums[f];
    for (const AcrossTile& tile : tiles) {
      const std::span<const std::uint32_t> fours = tile.weights.fours();
      const double* sums = &tile.sums[f * 4 * fours.size()];
      for (const std::uint32_t four : fours)
        for (const std::uint32_t node : domain.basis_cells.four(four).node)
          field[node] += *sums++;
    }
  });
}

template <Motion motion, bool force>
void add_clock(Domain& domain, int clock) {
  constexpr SumRange fields = fields_of(motion, force);
  ClockTiles& tiles = domain.clock_tiles[static_cast<std::size_t>(clock)];
  tiles.sums.add_to(
      domain.grid, fields, domain.tiles, domain.workers, domain.windows, [&](std::size_t n, double* window) {
        RowRange touched;
        for (const Particles& p : domain.sets)
          touched.add(scatter_set<motion, force>(domain, p, clock, tiles.sums.filled()[n], window));
        return touched;
      });
  if (tiles.across.empty())
    return;
  domain.workers.run(tiles.across.size(), [&](std::size_t task) {
    AcrossTile& tile = tiles.across[task];
    const Particles& p = domain.sets[tile.set];
    const auto scatter_as = [&]<bool affine, bool damped>() {
      scatter_across<motion, force, affine, damped>(p, tile, domain.basis_cells, domain.spec.gravity);
    };
    if (force && p.traits.damped)
      p.traits.affine ? scatter_as.template operator()<true, force>()
                      : scatter_as.template operator()<false, force>();
    else
      p.traits.affine ? scatter_as.template operator()<true, false>()
                      : scatter_as.template operator()<false, false>();
  });
  add_across(domain, tiles.across, fields);
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
