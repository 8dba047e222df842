#include "mpm_domain/dispersion/fullness.hpp"
#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/passes/passes.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "mpm_domain/transfer/sharp_transfer.hpp"

namespace tremolo::mpm_domain {

namespace {

void scatter_clocks(Ground& ground, Step& step) {
  const int first = step.ticks.first_due();
  if (!step.ticks.is_first())
    weigh_across(ground, first);
  clear(ground, ScatterPart::both, step.nodes.from(first));
  step.shared.take_masses(first);
  for (int clock = first; clock < step.ticks.clocks(); ++clock) {
    add_particles(ground, ScatterPart::both, clock);
    fold(ground, ScatterPart::both, step.nodes.ties_of(clock));
    step.shared.keep(clock);
  }
  step.shared.add_steady();
}

void book_stress(Step& step, const GatherTotals& sums) {
  step.bookings.add(sums.works, [&energy = step.energy](const auto& works) {
    energy.elastic += works[0];
    energy.plastic += works[1];
    energy.viscous += works[2];
  });
  step.fastest = sums.max_speed;
}

void gather_all(Ground& ground, Step& step) {
  prolong(ground, NodeGroup::velocity, step.nodes.ties_of(0));
  book_stress(step, gather(ground, step.dt, {.velocity = true, .position = true, .strain = true}, 0));
}

/// Fast clocks come first: then each slower clock may replace the velocities of nodes that it shares with
/// faster ones by those that its own particles read.
void gather_velocities(Ground& ground, Step& step) {
  for (int clock = step.ticks.clocks() - 1; clock >= step.ticks.first_ending(); --clock) {
    prolong(ground, NodeGroup::velocity, step.nodes.ties_of(clock));
    gather(ground, step.ticks.dt_of(clock), {.velocity = true, .sharp = ground.is_sharp()}, clock);
  }
}

void scatter_momenta(Ground& ground, Step& step) {
  const int first = step.ticks.first_ending();
  clear(ground, ScatterPart::momentum, step.nodes.from(first));
  step.shared.take_momenta(first);
  for (int clock = first; clock < step.ticks.clocks(); ++clock) {
    add_particles(ground, ScatterPart::momentum, clock);
    fold(ground, ScatterPart::momentum, step.nodes.ties_of(clock));
  }
}

void gather_rest(Ground& ground, Step& step) {
  const bool drifts = step.ticks.clocks() == 1 && ground.spec.scheme.transfer == Transfer::apic;
  const bool sharp = ground.is_sharp();
  const GatherParts rest = drifts
                               ? GatherParts{.drift = true, .strain = true, .remapped = true, .sharp = sharp}
                               : GatherParts{.position = true, .strain = true, .remapped = true};
  GatherTotals sums;
  for (int clock = step.ticks.clocks() - 1; clock >= step.ticks.first_ending(); --clock) {
    step.shared.take_mean(clock);
    prolong(ground, NodeGroup::velocity, step.nodes.ties_of(clock));
    sums += gather(ground, step.ticks.dt_of(clock), rest, clock);
    step.shared.add_mean(clock);
  }
  book_stress(step, sums);
}

void scatter_masses(Ground& ground, Step& /*step*/) {
  scatter(ground, ScatterPart::motion);
}

void scatter_sharpened(Ground& ground, Step& /*step*/) {
  find_fullness(ground);
  scatter_sharp_forces(ground);
}

/// Accelerations are for output alone.
void find_accelerations(Ground& ground, Step& step) {
  if (step.ticks.first_ending() > 0)
    return;
  step.shared.mean_accelerations();
  prolong(ground, NodeGroup::acceleration, ground.soil_ties);
}

} // namespace

std::vector<Pass> transfer_passes(Ground& ground) {
  std::vector<Pass> passes;
  const auto add = [&](Phase phase, const char* name, void (*run)(Ground&, Step&)) {
    passes.push_back({phase, name, [&ground, run](Step& step) { run(ground, step); }});
  };
  if (ground.is_sharp()) {
    add(Phase::scatter, "particles to grid", scatter_masses);
    add(Phase::scatter, "sharpened forces", scatter_sharpened);
  } else if (!ground.has_water()) {
    add(Phase::scatter, "particles to grid", scatter_clocks);
  }
  if (!ground.is_remapped()) {
    add(Phase::stress, "grid to particles, stress", gather_all);
  } else {
    if (!ground.has_flow()) {
      add(Phase::gather, "grid to particles", gather_velocities);
      add(Phase::gather, "velocities to grid again", scatter_momenta);
    }
    add(Phase::stress, "strain and stress", gather_rest);
  }
  add(Phase::settle, "accelerations", find_accelerations);
  return passes;
}

} // namespace tremolo::mpm_domain
