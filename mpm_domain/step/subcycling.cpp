#include "mpm_domain/step/subcycling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <initializer_list>
#include <numeric>
#include <stdexcept>

namespace tremolo::mpm_domain {

Subcycling::Subcycling(Domain& domain)
    : domain_(domain), clocks_(domain.clocks.count()), affine_(domain.spec.scheme.transfer == Transfer::apic),
      nodes_(domain), shared_(static_cast<std::size_t>(clocks_) - 1),
      kinetic_(static_cast<std::size_t>(clocks_)) {
  restart();
}

void Subcycling::restart() {
  nodes_ = ClockNodes(domain_);
  Grid& grid = domain_.grid;
  for (NodeField* field : {&grid.mass, &grid.momentum_x, &grid.momentum_y, &grid.force_x, &grid.force_y,
                           &grid.dashpot_x, &grid.dashpot_y, &grid.vx, &grid.vy, &grid.vx_new, &grid.vy_new})
    std::ranges::fill(*field, 0.0);
  for (NodeField* field : {&grid.ax, &grid.ay})
    std::ranges::fill(*field, 0.0);
  resize_shared();
  for (Shared& s : shared_)
    for (NodeField* field : {&s.steady_x, &s.steady_y})
      field->assign(grid.size(), 0.0);
  steady_known_ = 0.0;
}

void Subcycling::require_fit() const {
  for (const Shared& s : shared_)
    for (const NodeField* field : {&s.steady_x, &s.steady_y})
      if (field->size() != domain_.grid.size())
        throw std::runtime_error(fmt::format("steady forces of {} nodes do not go with a grid of {} nodes",
                                             field->size(), domain_.grid.size()));
}

void Subcycling::resize_shared() {
  for (Shared& s : shared_)
    for (NodeField* field : {&s.mass, &s.momentum_x, &s.momentum_y, &s.change_x, &s.change_y, &s.vx_mean,
                             &s.vy_mean, &s.vx_new_mean, &s.vy_new_mean})
      field->assign(domain_.grid.size(), 0.0);
}

double Subcycling::updates_per_step() const {
  double updates = 0.0;
  const std::size_t blocks = domain_.blocks_per_clock();
  const std::size_t levels = domain_.mesh->lattices().size();
  for (const Particles& set : domain_.sets)
    for (int clock = 0; clock < clocks_; ++clock) {
      const auto c = static_cast<std::size_t>(clock);
      const auto count = [&](std::size_t first, std::size_t n) {
        return static_cast<double>(set.block_start[first + n] - set.block_start[first]);
      };
      updates += (count(c * blocks, blocks) + count(domain_.block_count() + c * levels, levels)) *
                 static_cast<double>(1 << clock);
    }
  return updates;
}

int Subcycling::slowest_at(int tick) const {
  const auto place = static_cast<unsigned>(tick % ticks());
  return place == 0 ? 0 : clocks_ - 1 - std::countr_zero(place);
}

/// act(n) for all nodes of the rows.
template <typename Act>
void Subcycling::over(std::span<const NodeRange> rows, const Act& act) {
  domain_.workers.run(rows.size(), [&](std::size_t row) {
    for (std::size_t n = rows[row].begin; n < rows[row].end; ++n)
      act(n);
  });
}

/// The nodes of a clock and faster ones start with what slower particles brought of motion or of momentum
/// alone.
void Subcycling::take_held(int first, ScatterPart part) {
  Grid& grid = domain_.grid;
  const bool all = part == ScatterPart::both;
  over(nodes_.from(first), [&](std::size_t n) {
    grid.momentum_x[n] = grid.momentum_y[n] = 0.0;
    if (all)
      grid.mass[n] = grid.force_x[n] = grid.force_y[n] = grid.dashpot_x[n] = grid.dashpot_y[n] = 0.0;
  });
  if (first == 0)
    return;
  const Shared& held = shared(first - 1);
  over(nodes_.shared(first - 1), [&](std::size_t n) {
    grid.momentum_x[n] = held.momentum_x[n];
    grid.momentum_y[n] = held.momentum_y[n];
    if (all)
      grid.mass[n] = held.mass[n];
  });
}

void Subcycling::fold(int clock, ScatterPart part) {
  Grid& grid = domain_.grid;
  const auto restrict = [&](std::initializer_list<NodeField*> fields) {
    for (NodeField* field : fields)
      domain_.mesh->prolongation().restrict(*field, nodes_.ties_of(clock));
  };
  restrict({&grid.momentum_x, &grid.momentum_y});
  if (part == ScatterPart::both)
    restrict({&grid.mass, &grid.force_x, &grid.force_y});
}

void Subcycling::prolong(int clock) {
  Grid& grid = domain_.grid;
  for (NodeField* field : {&grid.vx, &grid.vy, &grid.vx_new, &grid.vy_new})
    domain_.mesh->prolongation().prolong(*field, nodes_.ties_of(clock));
}

/// Shared nodes remember what this and slower clocks brought. They count what forces are more than steady in
/// steps of the faster clock from here on: dt_q f_q = dt_(q+1) (2 f_q).
void Subcycling::keep(int clock) {
  Grid& grid = domain_.grid;
  Shared& s = shared(clock);
  const bool first = steady_known_ == 0.0;
  over(nodes_.shared(clock), [&](std::size_t n) {
    s.mass[n] = grid.mass[n];
    s.momentum_x[n] = grid.momentum_x[n];
    s.momentum_y[n] = grid.momentum_y[n];
    s.change_x[n] = s.change_y[n] = 0.0;
    s.vx_mean[n] = s.vy_mean[n] = s.vx_new_mean[n] = s.vy_new_mean[n] = 0.0;
    if (first) {
      s.steady_x[n] = grid.force_x[n];
      s.steady_y[n] = grid.force_y[n];
    }
    grid.force_x[n] = 2.0 * (grid.force_x[n] - s.steady_x[n]);
    grid.force_y[n] = 2.0 * (grid.force_y[n] - s.steady_y[n]);
  });
}

void Subcycling::add_steady() {
  Grid& grid = domain_.grid;
  for (int clock = 0; shares(clock); ++clock) {
    const Shared& s = shared(clock);
    const double share = steady_share(clock);
    over(nodes_.shared(clock), [&](std::size_t n) {
      if (nodes_.clock_of(n) < first_due())
        return;
      grid.force_x[n] += share * s.steady_x[n];
      grid.force_y[n] += share * s.steady_y[n];
    });
  }
}

void Subcycling::scatter() {
  const int first = first_due();
  if (tick_ > 0)
    weigh_across(domain_, first);
  take_held(first, ScatterPart::both);
  for (int clock = first; clock < clocks_; ++clock) {
    scatter_clock(domain_, ScatterPart::both, clock);
    fold(clock, ScatterPart::both);
    if (shares(clock))
      keep(clock);
  }
  add_steady();
  steady_known_ = 1.0;
}

double Subcycling::velocities() {
  double gained = 0.0;
  for (int clock = first_due(); clock < clocks_; ++clock)
    gained += grid_velocities(domain_, nodes_.of(clock)) - kinetic_[static_cast<std::size_t>(clock)];
  return gained;
}

GridUpdate Subcycling::update() {
  GridUpdate sum;
  for (int clock = first_due(); clock < clocks_; ++clock) {
    const GridUpdate part = update_grid(domain_, kick_of(clock), nodes_.of(clock));
    kinetic_[static_cast<std::size_t>(clock)] = part.kinetic;
    sum.gravity_work += part.gravity_work;
    sum.dashpot_relief += part.dashpot_relief;
  }
  sum.kinetic = std::accumulate(kinetic_.begin(), kinetic_.end(), 0.0);
  const Grid& grid = domain_.grid;
  for (int clock = 0; shares(clock); ++clock) {
    Shared& s = shared(clock);
    over(nodes_.shared(clock), [&](std::size_t n) {
      if (nodes_.clock_of(n) < first_due())
        return;
      const double change_x = grid.vx_new[n] - grid.vx[n];
      const double change_y = grid.vy_new[n] - grid.vy[n];
      s.change_x[n] += change_x;
      s.change_y[n] += change_y;
      s.momentum_x[n] = affine_ ? s.mass[n] * grid.vx_new[n] : s.momentum_x[n] + s.mass[n] * change_x;
      s.momentum_y[n] = affine_ ? s.mass[n] * grid.vy_new[n] : s.momentum_y[n] + s.mass[n] * change_y;
    });
  }
  return sum;
}

// Fast clocks first: each slower one finds on its shared nodes what it reads there in the place of what the
// faster ones have read.
void Subcycling::gather_velocities() {
  Grid& grid = domain_.grid;
  for (int clock = clocks_ - 1; clock >= first_ending(); --clock) {
    if (shares(clock)) {
      const Shared& s = shared(clock);
      over(nodes_.shared(clock), [&](std::size_t n) {
        grid.vx[n] = grid.vx_new[n] - s.change_x[n];
        grid.vy[n] = grid.vy_new[n] - s.change_y[n];
      });
    }
    prolong(clock);
    gather_clock(domain_, dt_of(clock), {.velocity = true}, false, clock);
  }
}

void Subcycling::remap() {
  const int first = first_ending();
  take_held(first, ScatterPart::momentum);
  for (int clock = first; clock < clocks_; ++clock) {
    scatter_clock(domain_, ScatterPart::momentum, clock);
    fold(clock, ScatterPart::momentum);
  }
  remap_velocities(domain_, nodes_.from(first));
}

/// The mean over a step of a clock is half of that over the step of the next slower one.
void Subcycling::add_mean(int clock) {
  const Grid& grid = domain_.grid;
  Shared& s = shared(clock - 1);
  over(nodes_.shared(clock - 1), [&](std::size_t n) {
    s.vx_mean[n] += 0.5 * grid.vx[n];
    s.vy_mean[n] += 0.5 * grid.vy[n];
    s.vx_new_mean[n] += 0.5 * grid.vx_new[n];
    s.vy_new_mean[n] += 0.5 * grid.vy_new[n];
  });
}

void Subcycling::take_mean(int clock) {
  Grid& grid = domain_.grid;
  const Shared& s = shared(clock);
  over(nodes_.shared(clock), [&](std::size_t n) {
    grid.vx[n] = s.vx_mean[n];
    grid.vy[n] = s.vy_mean[n];
    grid.vx_new[n] = s.vx_new_mean[n];
    grid.vy_new[n] = s.vy_new_mean[n];
  });
}

GatherSums Subcycling::gather_rest() {
  GatherSums sums;
  for (int clock = clocks_ - 1; clock >= first_ending(); --clock) {
    if (shares(clock))
      take_mean(clock);
    prolong(clock);
    const GatherSums part =
        gather_clock(domain_, dt_of(clock), {.position = true, .strain = true}, true, clock);
    sums.elastic += part.elastic;
    sums.plastic += part.plastic;
    sums.max_speed = std::max(sums.max_speed, part.max_speed);
    if (clock > 0)
      add_mean(clock);
  }
  if (first_ending() == 0)
    mean_acceleration();
  return sums;
}

/// For output: of the step of the slowest particles that share a node, who gave it impulses.
void Subcycling::mean_acceleration() {
  Grid& grid = domain_.grid;
  for (int clock = clocks_ - 2; clock >= 0; --clock) {
    const Shared& s = shared(clock);
    over(nodes_.shared(clock), [&](std::size_t n) {
      grid.ax[n] = s.change_x[n] / dt_of(clock);
      grid.ay[n] = s.change_y[n] / dt_of(clock);
    });
  }
  for (int clock = 0; clock < clocks_; ++clock)
    for (NodeField* field : {&grid.ax, &grid.ay})
      domain_.mesh->prolongation().prolong(*field, nodes_.ties_of(clock));
}

} // namespace tremolo::mpm_domain
