#pragma once

// The passes of a step: those that all rooms give for a domain, by phase. Within a phase they stand in the
// order of this list of rooms: transfers, nodes, boundary, books, water, structures, reduced dispersion,
// ranks. It holds wherever one pass needs what another of its phase has done, and the ledger adds up in it:
// faces are read when all is on the grid, structures meet the remapped velocities after the power of all
// other forces on them has been found, and velocities are sharpened when they are final.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// @param domain      outlives the passes; what stands behind its faces is there already
/// @param free_field  of the faces
/// @throws std::invalid_argument if the domain has faces and nobody gives their free field
std::vector<Pass> recipe(Domain& domain, const FreeFieldSource& free_field);

} // namespace tremolo::mpm_domain
