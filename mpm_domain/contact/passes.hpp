#pragma once

// What structures do in a step:
//
//   contact:  impulses change v+ of the nodes and of the bodies (contact.hpp)
//   remap:    the same impulses take off u what would drive soil into bodies (musl)
//   bodies:   x += dt v+
//
// What contact takes off u strains no soil, but the next step begins with it, v- being what the particles
// have: the other half of its power (step/node_passes.hpp) belongs to that step, and is booked here with the
// stresses of this one. Structures have one clock.

#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

class Contact;

std::vector<Pass> contact_passes(Ground& ground, Contact& contact);

} // namespace tremolo::mpm_domain
