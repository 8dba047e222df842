#include "mpm_domain/clocks/shared_nodes.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace tremolo::mpm_domain {

SharedNodes::SharedNodes(Ground& ground, const Ticks& ticks, const ClockNodes& nodes)
    : ground_(ground), ticks_(ticks), nodes_(nodes), kept_(static_cast<std::size_t>(ticks.clocks()) - 1) {
  restart();
}

void SharedNodes::restart() {
  clear_step();
  for (Kept& k : kept_)
    for (std::vector<double>* field : {&k.steady_x, &k.steady_y})
      field->assign(ground_.grid.size(), 0.0);
  steady_known_ = false;
}

void SharedNodes::require_fit() const {
  for (const Kept& k : kept_)
    for (const std::vector<double>* field : {&k.steady_x, &k.steady_y})
      if (field->size() != ground_.grid.size())
        throw std::runtime_error(fmt::format("steady forces of {} nodes do not go with a grid of {} nodes",
                                             field->size(), ground_.grid.size()));
}

/// Clears all state that lasts for one step only.
void SharedNodes::clear_step() {
  for (Kept& k : kept_)
    for (std::vector<double>* field : {&k.mass, &k.momentum_x, &k.momentum_y, &k.change_x, &k.change_y,
                                       &k.vx_strain, &k.vy_strain, &k.vx_after, &k.vy_after})
      field->assign(ground_.grid.size(), 0.0);
}

/// act(n) for all nodes of the rows.
template <typename Act>
void SharedNodes::over(std::span<const NodeRange> rows, const Act& act) {
  ground_.workers.run(rows.size(), [&](std::size_t row) {
    for (std::size_t n = rows[row].begin; n < rows[row].end; ++n)
      act(n);
  });
}

void SharedNodes::take_masses(int first_due) {
  take_momenta(first_due);
  if (first_due > 0)
    over(nodes_.shared(first_due - 1),
         [&, &held = of(first_due - 1)](std::size_t n) { ground_.grid.mass[n] = held.mass[n]; });
}

void SharedNodes::take_momenta(int first_ending) {
  if (first_ending > 0)
    over(nodes_.shared(first_ending - 1), [&, &held = of(first_ending - 1)](std::size_t n) {
      ground_.grid.momentum_x[n] = held.momentum_x[n];
      ground_.grid.momentum_y[n] = held.momentum_y[n];
    });
}

/// From here on the unsteady part of the forces is applied in steps of the faster clock: dt_q f_q = dt_(q+1)
/// (2 f_q).
void SharedNodes::keep(int clock) {
  if (!shares(clock))
    return;
  Grid& grid = ground_.grid;
  over(nodes_.shared(clock), [&, &k = of(clock)](std::size_t n) {
    k.mass[n] = grid.mass[n];
    k.momentum_x[n] = grid.momentum_x[n];
    k.momentum_y[n] = grid.momentum_y[n];
    k.change_x[n] = k.change_y[n] = 0.0;
    k.vx_strain[n] = k.vy_strain[n] = k.vx_after[n] = k.vy_after[n] = 0.0;
    if (!steady_known_) {
      k.steady_x[n] = grid.force_x[n];
      k.steady_y[n] = grid.force_y[n];
    }
    grid.force_x[n] = 2.0 * (grid.force_x[n] - k.steady_x[n]);
    grid.force_y[n] = 2.0 * (grid.force_y[n] - k.steady_y[n]);
  });
}

void SharedNodes::add_steady() {
  Grid& grid = ground_.grid;
  for (int clock = 0; shares(clock); ++clock) {
    const double share = ticks_.steady_share(clock);
    over(nodes_.shared(clock), [&, &k = of(clock)](std::size_t n) {
      if (nodes_.clock_of(n) < ticks_.first_due())
        return;
      grid.force_x[n] += share * k.steady_x[n];
      grid.force_y[n] += share * k.steady_y[n];
    });
  }
  steady_known_ = true;
}

void SharedNodes::follow_update() {
  const Grid& grid = ground_.grid;
  for (int clock = 0; shares(clock); ++clock)
    over(nodes_.shared(clock), [&, &k = of(clock)](std::size_t n) {
      if (nodes_.clock_of(n) < ticks_.first_due())
        return;
      k.change_x[n] += grid.vx_after[n] - grid.vx_before[n];
      k.change_y[n] += grid.vy_after[n] - grid.vy_before[n];
      k.momentum_x[n] = k.mass[n] * grid.vx_after[n];
      k.momentum_y[n] = k.mass[n] * grid.vy_after[n];
    });
}

void SharedNodes::take_mean(int clock) {
  if (!shares(clock))
    return;
  Grid& grid = ground_.grid;
  over(nodes_.shared(clock), [&, &k = of(clock)](std::size_t n) {
    grid.vx_strain[n] = k.vx_strain[n];
    grid.vy_strain[n] = k.vy_strain[n];
    grid.vx_after[n] = k.vx_after[n];
    grid.vy_after[n] = k.vy_after[n];
  });
}

void SharedNodes::add_mean(int clock) {
  if (clock == 0)
    return;
  const Grid& grid = ground_.grid;
  over(nodes_.shared(clock - 1), [&, &k = of(clock - 1)](std::size_t n) {
    k.vx_strain[n] += 0.5 * grid.vx_strain[n];
    k.vy_strain[n] += 0.5 * grid.vy_strain[n];
    k.vx_after[n] += 0.5 * grid.vx_after[n];
    k.vy_after[n] += 0.5 * grid.vy_after[n];
  });
}

void SharedNodes::mean_accelerations() {
  Grid& grid = ground_.grid;
  for (int clock = ticks_.clocks() - 2; clock >= 0; --clock)
    over(nodes_.shared(clock), [&, &k = of(clock)](std::size_t n) {
      grid.ax[n] = k.change_x[n] / ticks_.dt_of(clock);
      grid.ay[n] = k.change_y[n] / ticks_.dt_of(clock);
    });
}

} // namespace tremolo::mpm_domain
