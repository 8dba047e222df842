#pragma once

// Ranks of one machine talk through files in memory. Those of a killed rank stay when mpirun is killed too,
// so they lie in a folder that the run removes.

#include <cstdlib>
#include <unistd.h>

namespace tremolo::mpm_domain {

/// Environment variable of ranks on the run's machine: the run's folder for such files.
inline constexpr const char* shared_memory_variable = "TREMOLO_SHARED_MEMORY";

/// Call it before MPI is initialised. On machines without that folder Open MPI chooses another one.
inline void use_shared_memory_of_run() {
  // NOLINTBEGIN(concurrency-mt-unsafe): no thread runs yet
  const char* folder = std::getenv(shared_memory_variable);
  if (folder != nullptr && ::access(folder, W_OK | X_OK) == 0)
    ::setenv("OMPI_MCA_btl_vader_backing_directory", folder, 1);
  // NOLINTEND(concurrency-mt-unsafe)
}

} // namespace tremolo::mpm_domain
