#pragma once

#include "mpm_domain/domain.hpp"

namespace tremolo::mpm_domain {

/// Water velocities of particles from the grid, as gather() does for the grains: with APIC v_f = sum S v_f+
/// and its B, with FLIP v_f += sum S (v_f+ - v_f-). The water moves through the grains: particles stay with
/// these.
void gather_water(Domain& domain);

} // namespace tremolo::mpm_domain
