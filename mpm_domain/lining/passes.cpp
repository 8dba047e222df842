#include "mpm_domain/lining/passes.hpp"

#include "mpm_domain/lining/linings.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

namespace {

void meet_linings(Ground& ground, Linings& linings, Step& step) {
  EnergyLedger& energy = step.energy;
  for (LiningBody& lining : linings.bodies()) {
    const LiningWork work = lining.meet(ground, step.kicks.front(), step.dt);
    step.kinetic.front() += work.kinetic;
    step.kinetic_off_grid += lining.beam().kinetic_energy();
    energy.gravity += work.gravity;
    energy.drag += work.drag;
    energy.friction += work.friction;
    energy.impact += work.impact;
    energy.viscous += work.elements; // the part that stays in the elements goes to elastic work below
  }
}

void move_linings(Ground& ground, Linings& linings, Step& step) {
  step.fastest = std::max(step.fastest, linings.fastest_point());
  for (LiningBody& lining : linings.bodies()) {
    const double before = lining.beam().strain_energy();
    step.moved += lining.move(ground, step.dt);
    const double stored = lining.beam().strain_energy() - before;
    step.energy.elastic += stored;
    step.energy.viscous -= stored;
  }
}

} // namespace

std::vector<Pass> lining_passes(Ground& ground, Linings& linings) {
  if (!linings.any())
    return {};
  std::vector<Pass> passes{
      {Phase::contact, "linings", [&](Step& step) { meet_linings(ground, linings, step); }},
      {Phase::bodies, "linings move", [&](Step& step) { move_linings(ground, linings, step); }}};
  if (ground.is_remapped())
    passes.push_back({Phase::remap, "linings remap", [&](Step& step) {
                        for (const LiningBody& lining : linings.bodies())
                          step.energy.transfer += step.kicks.front() * lining.meet_remapped(ground);
                      }});
  return passes;
}

} // namespace tremolo::mpm_domain
