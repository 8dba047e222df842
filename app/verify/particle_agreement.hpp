#pragma once

// Deviation of the particle velocities v of a run from the exact ones e. Sums run over the particles of a
// region and the frames of the run:
//
//   relative L2 error    sqrt( sum |v - e|^2 / sum |e|^2 )
//   peak error           max |v - e| / max |e|
//   phase lag            tau with which sum |v(t) - e(t - tau)|^2 is least, by Gauss-Newton steps
//                        d tau = - sum e' . (v - e) / sum |e'|^2 from tau = 0
//
// A material point of the exact field keeps its place, so e is taken where the particle was at the start.

#include "results/run_file.hpp"
#include "scene/case.hpp"
#include "wavefield/superposition.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tremolo::app {

/// One region of the box.
struct Agreement {
  std::string name;
  std::size_t particles = 0;
  double relative_l2 = 0.0; ///< 1
  double peak_error = 0.0;  ///< 1
  double phase_lag = 0.0;   ///< s, positive where the computed wave is late
};

struct ParticleAgreement {
  double boundary_width = 0.0;        ///< m; nearer than this to a side or to the base is "near"
  std::vector<Agreement> regions;     ///< whole, interior, near sides, near base; empty ones left out
  std::vector<double> x, y;           ///< [particles] at the start, m
  std::vector<double> relative_error; ///< [particles] rms over time of |v - e| over the rms of |e| of all
};

/// Initial positions of a run's particles, m: [particles * 2].
/// @throws std::runtime_error where the run has no frames
std::vector<double> initial_positions(const results::RunReader& run);

/// The velocities of a frame, m/s: [particles * 2].
/// @throws std::runtime_error where they are missing, not finite, or of another number of particles
std::vector<double> velocities(const results::RunReader& run, std::size_t frame, std::size_t particles);

/// Compares all frames of a run with the exact field.
/// @throws std::runtime_error where the run lacks what is needed, or the exact field is at rest throughout
ParticleAgreement compare_particles(const results::RunReader& run, const scene::Case& scene,
                                    const wavefield::Superposition& field);

} // namespace tremolo::app
