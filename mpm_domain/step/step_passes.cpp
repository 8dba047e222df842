#include "mpm_domain/step/step_passes.hpp"

#include "mpm_domain/grid/periodic_sides.hpp"
#include "mpm_domain/particles/splitting.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/step/time_step.hpp"

#include <algorithm>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

void choose_step(Domain& domain, Step& step) {
  const double before = step.dt;
  follow_clock(domain, step.time);
  if (!domain.share)
    step.bounds = step_bounds(domain);
  step.dt = next_time_step(domain, step.bounds, step.max_speed, before);
  step.kick = 0.5 * (before + step.dt);
  step.ticks.set_step(step.dt, step.kick);
}

void order(Domain& domain, Step& step) {
  if (domain.spec.periodic())
    for (Particles& set : domain.sets_of_soil())
      wrap(set, domain.spec.box);
  make_room(domain, step.time, step.count);
  split_particles(domain);
  sort_particles(domain);
  step.nodes = ClockNodes(domain);
  step.shared.restart();
  step.moved = 0.0;
}

void begin_earthwork(Domain& domain, Step& step) {
  domain.earthworks.begin(domain, [&] { order(domain, step); });
  if (!domain.share)
    return;
  step.bounds = step_bounds(domain); // also of soil that has come
  take_largest(domain, step.bounds);
}

void sort(Domain& domain, Step& step) {
  // On a graded mesh a particle must not come near another lattice within the step either.
  const double moves = domain.mesh ? step.max_speed * step.dt : 0.0;
  if (step.moved + moves < domain.sort_distance())
    weigh_across(domain);
  else
    order(domain, step);
}

/// The first rank broadcasts the velocities at faces that structures have changed, since others work out some
/// of these faces too.
void share_structure_velocities(Domain& domain) {
  Grid& grid = domain.grid;
  std::vector<NodeField*> fields{&grid.vx_after, &grid.vy_after};
  if (domain.has_flow())
    fields.insert(fields.end(), {&grid.wx_after, &grid.wy_after});
  std::vector<double*> shared;
  for (const std::size_t node : domain.boundary.shared_nodes())
    if (domain.share->structures_reach(domain.position_of(node).at))
      for (NodeField* const field : fields)
        shared.push_back(&(*field)[node]);
  if (shared.empty())
    return;
  std::vector<double> numbers;
  for (const double* const number : shared)
    numbers.push_back(*number);
  domain.share->ranks->follow_first(numbers);
  for (std::size_t n = 0; n < shared.size(); ++n)
    *shared[n] = numbers[n];
}

/// One message has what this step books and what bounds the next one.
void settle(Domain& domain, Step& step) {
  if (step.ticks.is_first())
    domain.share->times.count_step();
  follow_clock(domain, step.time + step.dt); // as it will be when the next step begins
  step.bounds = step_bounds(domain);
  for (double* const largest : {&step.fastest, &step.pushed})
    step.bounds.push_back(*largest);
  step.bookings.settle(step.bounds);
  for (double* const largest : {&step.pushed, &step.fastest}) {
    *largest = step.bounds.back();
    step.bounds.pop_back();
  }
}

} // namespace

std::vector<Pass> step_passes(Domain& domain) {
  std::vector<Pass> passes{{Phase::step_length, "time step",
                            [&](Step& step) {
                              while (domain.earthworks.is_due(domain, step.time))
                                begin_earthwork(domain, step);
                              if (deal_anew_if_due(domain))
                                step.nodes = ClockNodes(domain);
                              choose_step(domain, step);
                            }},
                           {Phase::sort, "sort", [&](Step& step) { sort(domain, step); }}};
  if (!domain.share)
    return passes;
  if (!domain.share->structures.empty())
    passes.push_back(
        {Phase::contact, "structures at faces", [&](Step&) { share_structure_velocities(domain); }});
  passes.push_back({Phase::settle, "totals over ranks", [&](Step& step) { settle(domain, step); }});
  return passes;
}

} // namespace tremolo::mpm_domain
