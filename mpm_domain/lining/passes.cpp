#include "mpm_domain/lining/passes.hpp"

#include "mpm_domain/lining/linings.hpp"

#include <algorithm>
#include <array>

namespace tremolo::mpm_domain {

namespace {

void meet_linings(Ground& ground, Linings& linings, Step& step) {
  for (LiningBody& lining : linings.bodies()) {
    LiningWork work;
    double kinetic = 0.0;
    if (ground.has_structures_here()) {
      work = lining.meet(ground, step.kicks.front(), step.dt);
      kinetic = lining.beam().kinetic_energy();
    }
    step.bookings.add(sums_of(std::array{work.kinetic, kinetic, work.gravity, work.drag, work.friction,
                                         work.impact, work.elements}),
                      [&step, &energy = step.energy](const std::array<double, 7>& booked) {
                        step.kinetic.front() += booked[0];
                        step.kinetic_off_grid += booked[1];
                        energy.gravity += booked[2];
                        energy.drag += booked[3];
                        energy.friction += booked[4];
                        energy.impact += booked[5];
                        energy.viscous += booked[6]; // what stays in the elements goes to elastic work below
                      });
  }
}

void move_linings(Ground& ground, Linings& linings, Step& step) {
  if (ground.has_structures_here())
    step.fastest = std::max(step.fastest, linings.fastest_point());
  for (LiningBody& lining : linings.bodies()) {
    double stored = 0.0;
    if (ground.has_structures_here()) {
      const double before = lining.beam().strain_energy();
      step.pushed += lining.move(ground, step.dt);
      stored = lining.beam().strain_energy() - before;
    }
    step.bookings.add(sums_of(std::array{stored}),
                      [&energy = step.energy](const std::array<double, 1>& booked) {
                        energy.elastic += booked[0];
                        energy.viscous -= booked[0];
                      });
  }
}

void meet_remapped(Ground& ground, const Linings& linings, Step& step) {
  for (const LiningBody& lining : linings.bodies()) {
    const double power = ground.has_structures_here() ? lining.meet_remapped(ground) : 0.0;
    step.book_transfer(step.kicks.front(), sums_of(std::array{power}));
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
    passes.push_back(
        {Phase::remap, "linings remap", [&](Step& step) { meet_remapped(ground, linings, step); }});
  return passes;
}

} // namespace tremolo::mpm_domain
