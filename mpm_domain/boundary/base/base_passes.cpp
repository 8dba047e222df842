#include "mpm_domain/boundary/base/rigid_base.hpp"
#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

std::vector<Pass> RigidBase::passes(Ground& ground) {
  const auto halt = [this, &ground](Step&) { stop(ground.grid); };
  std::vector<Pass> passes{
      {Phase::scatter, "", halt},
      {Phase::forces, "inertia",
       [this, &ground](Step& step) {
         for (int clock = step.ticks.first_due(); clock < step.ticks.clocks(); ++clock)
           push(ground, step.ticks, clock, step.nodes.of(clock));
       }},
      {Phase::books, "", [this, &ground](Step& step) {
         for (int clock = step.ticks.first_due(); clock < step.ticks.clocks(); ++clock)
           step.bookings.add(power(ground, clock, step.nodes.of(clock)),
                             [&energy = step.energy, kick = step.ticks.kick_of(clock)](const auto& total) {
                               energy.input += kick * total[0];
                             });
       }}};
  if (ground.is_remapped()) {
    passes.push_back({Phase::gather, "", halt});
    passes.push_back({Phase::remap, "", [this, &ground](Step& step) {
                        for (int clock = step.ticks.first_ending(); clock < step.ticks.clocks(); ++clock)
                          step.remap_power[static_cast<std::size_t>(clock)][0] +=
                              remap_power(ground, clock, step.nodes.of(clock))[0];
                      }});
  }
  return passes;
}

} // namespace tremolo::mpm_domain
