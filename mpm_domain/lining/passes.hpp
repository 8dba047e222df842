#pragma once

// Passes of linings in a step:
//
//   contact:  impulses change v+ of the nodes; the beam makes its implicit step with them (lining_body.hpp)
//   remap:    tied segments remove from u the part that drives soil into linings (musl)
//   bodies:   x += dt v+
//
// The part of u that contact removes is booked as for structures (contact/passes.hpp).

#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

class Linings;

std::vector<Pass> lining_passes(Ground& ground, Linings& linings);

} // namespace tremolo::mpm_domain
