#include "mpm_domain/dispersion/sharpening.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/kernel/lanes.hpp"
#include "mpm_domain/spec/limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// q1 without the share of the step, and q2, for 2, 3 and 4 particles a cell and direction.
struct Filter {
  double first, second;
};
constexpr std::array<Filter, 3> filters{{{0.1255, 0.022}, {0.1125, 0.018}, {0.1157, 0.019}}};

/// Terms that sharpen a component: q1 across and along itself.
struct Firsts {
  double x, y;
};

/// A value and its neighbours in one direction, and chi of the inner three.
struct Line {
  std::array<Lanes, 5> v;
  std::array<Lanes, 3> chi;
};

/// A value's four neighbours along the diagonals, from lower left to upper right, and chi there and at
/// itself.
struct Diagonals {
  std::array<Lanes, 4> v;
  std::array<Lanes, 4> chi;
  Lanes chi_here;

  /// D_xy
  static Lanes difference(const std::array<Lanes, 4>& v) { return 0.25 * (v[1] + v[2] - v[0] - v[3]); }
};

/// The terms of (Q - 1) v.
struct OfVelocity {
  Sharpening q;

  Lanes along(const Line& at, double first) const {
    const auto& [v, chi] = at;
    const Lanes before = chi[0] * (2.0 * v[1] - v[0] - v[2]);
    const Lanes here = chi[1] * (2.0 * v[2] - v[1] - v[3]);
    const Lanes after = chi[2] * (2.0 * v[3] - v[2] - v[4]);
    return first * here + q.second * (2.0 * here - before - after);
  }
  Lanes across(const Diagonals& at) const { return q.dilation * (at.chi_here * Diagonals::difference(at.v)); }
};

/// The terms of (Q^T - 1) f.
struct OfForce {
  Sharpening q;

  Lanes along(const Line& at, double first) const {
    const auto& [f, chi] = at;
    const Lanes before = chi[0] * (first * f[1] + q.second * (2.0 * f[1] - f[0] - f[2]));
    const Lanes here = chi[1] * (first * f[2] + q.second * (2.0 * f[2] - f[1] - f[3]));
    const Lanes after = chi[2] * (first * f[3] + q.second * (2.0 * f[3] - f[2] - f[4]));
    return 2.0 * here - before - after;
  }
  Lanes across(const Diagonals& at) const {
    return q.dilation * Diagonals::difference({at.chi[0] * at.v[0], at.chi[1] * at.v[1], at.chi[2] * at.v[2],
                                               at.chi[3] * at.v[3]});
  }
};

template <typename Group>
[[gnu::always_inline]] inline Line line_at(const NodeField& field, const NodeField& chi, std::size_t n,
                                           std::ptrdiff_t step, Group group) {
  const double* const v = &field[n];
  const double* const c = &chi[n];
  return {{group.load(v - 2 * step), group.load(v - step), group.load(v), group.load(v + step),
           group.load(v + 2 * step)},
          {group.load(c - step), group.load(c), group.load(c + step)}};
}

template <typename Group>
[[gnu::always_inline]] inline std::array<Lanes, 4> corners_at(const NodeField& field, std::size_t n,
                                                              std::ptrdiff_t row, Group group) {
  const double* const v = &field[n];
  return {group.load(v - row - 1), group.load(v - row + 1), group.load(v + row - 1), group.load(v + row + 1)};
}

/// One component at a group of nodes from n on.
/// @param other  the other component
template <typename Term, typename Group>
[[gnu::always_inline]] inline Lanes sharpened(const Grid& grid, const NodeField& field,
                                              const NodeField& other, const Firsts& first, std::size_t n,
                                              Group group, const Term& term) {
  const std::ptrdiff_t row = grid.nx;
  return group.load(&field[n]) + term.along(line_at(field, grid.inside_x, n, 1, group), first.x) +
         term.along(line_at(field, grid.inside_y, n, row, group), first.y) +
         term.across({corners_at(other, n, row, group), corners_at(grid.inside_both, n, row, group),
                      group.load(&grid.inside_both[n])});
}

/// Writes two fields, sharpened, into sharp_x and sharp_y. In the outermost rows of the grid, where chi is
/// zero, they stay as they are.
template <typename Term>
void sharpen(Ground& ground, const NodeField& x, const NodeField& y, const Term& term) {
  Grid& grid = ground.grid;
  const std::vector<NodeRange>& rows = ground.soil_rows;
  const std::size_t reach = 2 * (static_cast<std::size_t>(grid.nx) + 1);
  ground.workers.run(rows.size(), [&](std::size_t r) {
    const auto [begin, end] = rows[r];
    if (begin < reach || end + reach > grid.size()) {
      std::copy(&x[begin], &x[begin] + (end - begin), &grid.sharp_x[begin]);
      std::copy(&y[begin], &y[begin] + (end - begin), &grid.sharp_y[begin]);
      return;
    }
    const Firsts of_x{term.q.first + term.q.dilation, term.q.first};
    const Firsts of_y{term.q.first, term.q.first + term.q.dilation};
    by_fours(begin, end, [&](std::size_t n, auto group) {
      group.store(&grid.sharp_x[n], sharpened(grid, x, y, of_x, n, group, term));
      group.store(&grid.sharp_y[n], sharpened(grid, y, x, of_y, n, group, term));
    });
  });
}

/// The step that soil in its first state is given, s.
double planned_step(const Ground& ground) {
  const Scheme& scheme = ground.spec.scheme;
  if (scheme.dt)
    return *scheme.dt;
  double least = std::numeric_limits<double>::infinity();
  for (const Particles& set : ground.sets)
    if (!set.index_of.empty()) {
      const Soil& soil = ground.spec.soils[set.soil_index];
      const double speed =
          materials::elasticity(set.law).p_wave_speed() * std::sqrt(soil.relaxation.unrelaxed());
      least = std::min(least, damped_step(largest_courant_number * ground.grid.h / speed, soil.damping_time,
                                          share_of(scheme.order)));
    }
  return scheme.fraction * least;
}

} // namespace

Sharpening sharpening_of(const Ground& ground) {
  materials::Elasticity slowest;
  double speed = std::numeric_limits<double>::infinity();
  for (const Particles& set : ground.sets)
    if (const materials::Elasticity& soil = materials::elasticity(set.law);
        !set.index_of.empty() && soil.s_wave_speed() < speed) {
      slowest = soil;
      speed = soil.s_wave_speed();
    }
  const auto of_step = [&](double c) { return std::pow(planned_step(ground) * c / ground.grid.h, 2) / 24.0; };
  const double of_shear = of_step(speed);
  const Filter& filter = filters.at(static_cast<std::size_t>(ground.spec.particles_per_cell) - 2);
  return {filter.first - of_shear, filter.second, of_shear - of_step(slowest.p_wave_speed())};
}

void sharpen_velocities(Ground& ground, const NodeField& vx, const NodeField& vy) {
  sharpen(ground, vx, vy, OfVelocity{sharpening_of(ground)});
}

void sharpen_forces(Ground& ground) {
  prolong(ground, NodeGroup::force); // what lies beyond a periodic side
  take_at_skirt(ground, std::array{&NodeFields::force_x, &NodeFields::force_y});
  Grid& grid = ground.grid;
  sharpen(ground, grid.force_x, grid.force_y, OfForce{sharpening_of(ground)});
  std::swap(grid.force_x, grid.sharp_x);
  std::swap(grid.force_y, grid.sharp_y);
  const Prolongation& ties = ground.ties();
  for (std::size_t r = 0; r < ties.tied_count(); ++r)
    grid.force_x[ties.tied(r)] = grid.force_y[ties.tied(r)] = 0.0;
  const double gravity = ground.spec.gravity;
  if (gravity == 0.0)
    return;
  ground.workers.run(ground.soil_rows.size(), [&](std::size_t r) {
    for (std::size_t n = ground.soil_rows[r].begin; n < ground.soil_rows[r].end; ++n)
      grid.force_y[n] -= gravity * grid.mass[n];
  });
}

} // namespace tremolo::mpm_domain
