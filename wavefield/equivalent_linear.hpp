#pragma once

#include "wavefield/layered_half_space.hpp"

#include <functional>
#include <span>
#include <vector>

namespace tremolo::wavefield {

/// Strain-dependent stiffness and damping of a layer, functions of the shear strain (1, not per cent).
struct StrainCurves {
  std::function<double(double)> modulus_reduction; ///< G / Gmax, in (0, 1]
  std::function<double(double)> damping;           ///< damping ratio, in [0, 0.5)
};

/// Acceleration of the incident wave along its polarisation at the top of the half-space, m/s2, at 0, dt, ...
/// (incident_motion.hpp makes it from an outcrop motion).
struct IncidentAcceleration {
  std::span<const double> samples;
  double dt = 0.0; ///< s
};

struct EquivalentLinearOptions {
  double strain_ratio = 0.65; ///< effective over largest strain
  double tolerance = 0.01;    ///< largest relative change of modulus and of damping ratio
  int max_iterations = 15;
  bool allow_non_convergence = false;
};

struct EquivalentLinearIteration {
  double modulus_change = 0.0;        ///< largest over the layers, relative
  double damping_change = 0.0;        ///< largest over the layers, relative
  std::vector<double> largest_strain; ///< of each layer, |gamma_xy| at its mid-depth
};

struct EquivalentLinearResult {
  LayeredHalfSpace profile; ///< with strain-compatible wave speeds and damping ratios
  std::vector<EquivalentLinearIteration> iterations;
  bool converged = false;
};

/// Equivalent linear analysis as SHAKE does it (Schnabel, Lysmer and Seed 1972), at any angle of incidence:
/// the strain of a layer is that of gamma_xy at its mid-depth. Poisson's ratio of a layer stays; its damping
/// ratio holds for shear and P-wave modulus alike. The half-space stays linear.
/// @param profile  Gmax as density vs^2; the layers' damping ratios are the first guess; a damping model
/// other
///                 than `none`
/// @param curves   one a layer
/// @throws std::invalid_argument for values outside their range
/// @throws std::runtime_error naming the layer that still changes, unless non-convergence is allowed
EquivalentLinearResult equivalent_linear(const LayeredHalfSpace& profile,
                                         std::span<const StrainCurves> curves, WaveType wave,
                                         double angle_rad, const IncidentAcceleration& motion,
                                         const EquivalentLinearOptions& options = {});

} // namespace tremolo::wavefield
