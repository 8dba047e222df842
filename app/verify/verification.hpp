#pragma once

#include "app/verify/particle_agreement.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

/// Computed and exact velocity (m/s) over time (s) at one material point.
struct PointHistory {
  std::string name;
  double x = 0.0, y = 0.0; ///< at the start, m
  std::vector<double> time, exact_vx, exact_vy, vx, vy;
};

/// A run held against the exact field of its incident wave.
struct Verification {
  ParticleAgreement particles;
  std::vector<PointHistory> points; ///< the monitors; without any, a particle at surface, mid-height and base
  std::optional<double> energy_residual; ///< largest |residual| of the energy ledger over the largest kinetic
                                         ///< energy, 1; nothing if the run has no ledger
};

/// @throws std::runtime_error where the run is not complete, is of a case whose exact field is not known
/// (why_not_exact), or lacks what is needed
Verification verify(const results::RunReader& run, const scene::Case& scene);

} // namespace tremolo::app
