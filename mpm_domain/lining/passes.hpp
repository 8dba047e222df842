#pragma once

// What linings do in a step:
//
//   contact:  impulses change v+ of the nodes; the beam makes its implicit step with them (lining_body.hpp)
//   remap:    tied segments take off u what would drive soil into linings (musl)
//   bodies:   x += dt v+
//
// What contact takes off u is booked as it is for structures (contact/passes.hpp).

#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

class Linings;

std::vector<Pass> lining_passes(Ground& ground, Linings& linings);

} // namespace tremolo::mpm_domain
