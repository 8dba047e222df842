#pragma once

#include "mpm_domain/ranks/communicator.hpp"

#include <memory>

namespace tremolo::mpm_domain {

/// Joins the other ranks that mpirun, or srun, has started with this process. They are left when the result
/// is destroyed, or all of them end at once if an exception does that.
/// @returns null for a process that was started alone, and in a build without MPI
std::unique_ptr<Communicator> join_ranks();

} // namespace tremolo::mpm_domain
