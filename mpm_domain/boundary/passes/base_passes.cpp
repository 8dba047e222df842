#include "mpm_domain/boundary/passes/passes.hpp"
#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

namespace {

void push_by_base(Ground& ground, Boundary& boundary, Step& step) {
  RigidBase& base = *boundary.rigid_base();
  if (step.ticks.is_first())
    base.move(boundary.free_field().front().velocity, step.dt, step.ticks.clocks());
  for (int clock = step.ticks.first_due(); clock < step.ticks.clocks(); ++clock)
    base.push(ground, step.ticks, clock, step.nodes.of(clock));
}

void book_inertia(Ground& ground, const RigidBase& base, Step& step) {
  for (int clock = step.ticks.first_due(); clock < step.ticks.clocks(); ++clock)
    step.bookings.add(base.power(ground, clock, step.nodes.of(clock)),
                      [&energy = step.energy, kick = step.ticks.kick_of(clock)](const auto& power) {
                        energy.input += kick * power[0];
                      });
}

void add_remap_power(Ground& ground, const RigidBase& base, Step& step) {
  for (int clock = step.ticks.first_ending(); clock < step.ticks.clocks(); ++clock)
    step.remap_power[static_cast<std::size_t>(clock)][0] +=
        base.remap_power(ground, clock, step.nodes.of(clock))[0];
}

} // namespace

std::vector<Pass> base_passes(Ground& ground, Boundary& boundary) {
  if (!boundary.rigid_base())
    return {};
  RigidBase& base = *boundary.rigid_base();
  const auto stop = [&](Step&) { base.stop(ground.grid); };
  std::vector<Pass> passes{
      {Phase::scatter, "", stop},
      {Phase::forces, "inertia", [&](Step& step) { push_by_base(ground, boundary, step); }},
      {Phase::books, "", [&](Step& step) { book_inertia(ground, base, step); }}};
  if (ground.is_remapped()) {
    passes.push_back({Phase::gather, "", stop});
    passes.push_back({Phase::remap, "", [&](Step& step) { add_remap_power(ground, base, step); }});
  }
  return passes;
}

} // namespace tremolo::mpm_domain
