#pragma once

// Passes of structures in a step:
//
//   contact:  impulses change v+ of the nodes and of the bodies (contact.hpp)
//   remap:    these impulses remove from u the part that drives soil into bodies (musl)
//   bodies:   x += dt v+
//
// The part of u that contact removes strains no soil, but the next step still begins with it, since v- is
// computed from the particles: the other half of its power (step/node_passes.hpp) belongs to that step, and
// is booked here with the stresses of this one. Structures have one clock.

#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

class Contact;

std::vector<Pass> contact_passes(Ground& ground, Contact& contact);

} // namespace tremolo::mpm_domain
