#include "mpm_domain/contact/passes.hpp"

#include "mpm_domain/contact/contact.hpp"

#include <algorithm>
#include <array>

namespace tremolo::mpm_domain {

namespace {

void meet_bodies(Ground& ground, Contact& contact, Step& step) {
  ContactWork work;
  double kinetic = 0.0; // of the rigid bodies
  if (ground.has_structures_here()) {
    work = contact.meet(ground, step.kicks.front());
    kinetic = contact.kinetic_energy();
  }
  step.bookings.add(sums_of(std::array{work.kinetic, kinetic, work.gravity, work.load, work.drag,
                                       work.friction, work.impact}),
                    [&step, &energy = step.energy](const std::array<double, 7>& booked) {
                      step.kinetic.front() += booked[0];
                      step.kinetic_off_grid += booked[1];
                      energy.gravity += booked[2];
                      energy.static_ += booked[3];
                      energy.drag += booked[4];
                      energy.friction += booked[5];
                      energy.impact += booked[6];
                    });
}

void move_bodies(Ground& ground, Contact& contact, Step& step) {
  if (!ground.has_structures_here())
    return;
  step.fastest = std::max(step.fastest, contact.fastest_point());
  step.pushed += contact.move(ground, step.dt);
}

void meet_remapped(Ground& ground, Contact& contact, Step& step) {
  const double power = ground.has_structures_here() ? contact.meet_remapped(ground) : 0.0;
  step.book_transfer(step.kicks.front(), sums_of(std::array{power}));
}

} // namespace

std::vector<Pass> contact_passes(Ground& ground, Contact& contact) {
  if (!contact.any())
    return {};
  std::vector<Pass> passes{
      {Phase::contact, "contact", [&](Step& step) { meet_bodies(ground, contact, step); }},
      {Phase::bodies, "bodies", [&](Step& step) { move_bodies(ground, contact, step); }}};
  if (ground.is_remapped())
    passes.push_back({Phase::remap, "", [&](Step& step) { meet_remapped(ground, contact, step); }});
  return passes;
}

} // namespace tremolo::mpm_domain
