#include "mpm_domain/contact/passes.hpp"

#include "mpm_domain/contact/contact.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

namespace {

void meet_bodies(Ground& ground, Contact& contact, Step& step) {
  const ContactWork work = contact.meet(ground, step.kicks.front());
  step.kinetic.front() += work.kinetic;
  step.kinetic_off_grid += contact.kinetic_energy();
  EnergyLedger& energy = step.energy;
  energy.gravity += work.gravity;
  energy.static_ += work.load;
  energy.drag += work.drag;
  energy.friction += work.friction;
  energy.impact += work.impact;
}

void move_bodies(Ground& ground, Contact& contact, Step& step) {
  step.fastest = std::max(step.fastest, contact.fastest_point());
  step.moved += contact.move(ground, step.dt);
}

} // namespace

std::vector<Pass> contact_passes(Ground& ground, Contact& contact) {
  if (!contact.any())
    return {};
  std::vector<Pass> passes{
      {Phase::contact, "contact", [&](Step& step) { meet_bodies(ground, contact, step); }},
      {Phase::bodies, "bodies", [&](Step& step) { move_bodies(ground, contact, step); }}};
  if (ground.is_remapped())
    passes.push_back({Phase::remap, "", [&](Step& step) {
                        step.energy.transfer += step.kicks.front() * contact.meet_remapped(ground);
                      }});
  return passes;
}

} // namespace tremolo::mpm_domain
