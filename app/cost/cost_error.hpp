#pragma once

// The error of a run, particle velocity, relative L2:
//
//   to the exact field   over all particles and frames (particle_agreement.hpp)
//   to another run       sqrt( sum |v - r|^2 / sum |r|^2 ) over the monitors and the times of the reference
//   r;
//                        v between its rows by cubic Hermite interpolation of velocity and acceleration
//
// A monitor follows the particle nearest to its point, which on another mesh lies up to half a cell
// elsewhere.

#include "results/run_file.hpp"
#include "scene/case.hpp"

#include <string>
#include <vector>

namespace tremolo::app {

struct RunError {
  double relative_l2 = 0.0;
  double phase_lag = 0.0; ///< s, positive where the run is late; 0 where the reference is a run
};

/// @throws std::runtime_error where the run is not complete, or the exact field of its case is not known
RunError error_to_exact(const results::RunReader& run, const scene::Case& scene);

/// @throws std::runtime_error where a monitor of the reference is missing or at rest throughout
RunError error_to_run(const results::RunReader& run, const results::RunReader& reference);

} // namespace tremolo::app
