#pragma once

#include "wavefield/layers/layered_half_space.hpp"
#include "wavefield/layers/recorded_motion.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::wavefield {

/// The largest damping ratio of a layer: the complex moduli are made for ratios below 0.5. Masing's rule on
/// hyperbolic soil gives up to 2/pi.
inline constexpr double largest_damping = 0.49;

/// Strain-dependent stiffness and damping of a layer, functions of the shear strain (1, not per cent).
struct StrainCurves {
  std::function<double(double)> modulus_reduction; ///< G / Gmax, in (0, 1]
  std::function<double(double)> damping;           ///< damping ratio, in [0, 1); held at largest_damping
};

/// Acceleration of the incident wave along its polarisation at the top of the half-space, m/s2, at 0, dt, ...
/// (incident_motion.hpp makes it from an outcrop motion).
struct IncidentAcceleration {
  std::span<const double> samples;
  double dt = 0.0; ///< s
};

struct EquivalentLinearOptions {
  double strain_ratio = 0.65; ///< effective over largest strain
  double tolerance = 1e-3;    ///< largest relative change of modulus and of damping ratio
  int max_iterations = 50;
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
  std::vector<std::size_t> held_damping; ///< layers, by index, that the curves give more than largest_damping
};

/// The iteration still changes a layer after the last step that was allowed.
struct NotConverged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Equivalent linear analysis as SHAKE does it (Schnabel, Lysmer and Seed 1972), at any angle of incidence:
/// the strain of a layer is that of gamma_xy at its mid-depth. The curves hold for the shear modulus; the
/// bulk modulus of a layer and its damping ratio, the first guess, stay. The half-space stays linear.
/// @param profile  Gmax as density vs^2; the layers' damping ratios are the first guess; any damping
///                 model but `none`
/// @param curves   one a layer
/// @throws std::invalid_argument for values outside their range
/// @throws NotConverged naming the depth that still changes, unless non-convergence is allowed
EquivalentLinearResult equivalent_linear(const LayeredHalfSpace& profile,
                                         std::span<const StrainCurves> curves, WaveType wave,
                                         double angle_rad, const IncidentAcceleration& motion,
                                         const EquivalentLinearOptions& options = {});

/// equivalent_linear() where a motion in the ground is given, an acceleration (m/s2), and that from below is
/// sought: the moduli are those of the strains under the incident wave that gives the record
/// (incident_motion.hpp) up to its cutoff.
/// @throws std::runtime_error also where a pass asks for a shear strain above 1
EquivalentLinearResult equivalent_linear_under_record(const LayeredHalfSpace& profile,
                                                      std::span<const StrainCurves> curves, WaveType wave,
                                                      double angle_rad, const RecordedMotion& record,
                                                      const EquivalentLinearOptions& options = {});

/// Largest |gamma_xy| over time at mid-depth of every layer, of ground that moves as recorded (m/s2).
std::vector<double> largest_strains(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                    const RecordedMotion& record);

/// "the soil from 2 m to 3 m below the surface": a layer, by index.
std::string depth_range(const LayeredHalfSpace& profile, std::size_t layer);

} // namespace tremolo::wavefield
