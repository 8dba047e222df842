#pragma once

#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/transfer/snapshot.hpp"
#include "results/run_file.hpp"
#include "scene/case.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// Finds the particles that are part of the sliding masses of a case; null: it has none. The arguments
/// outlive what is returned.
Wanted in_sliding_masses(const scene::Case& scene, const Ground& ground);

/// The part of a run's file about sliding masses: a series each with the means over the mass m of the
/// soil that began within an outline,
///
///     a(t) = sum m_p a_p / sum m_p,
///
/// likewise velocity, displacement and position. a_x is the horizontal equivalent acceleration, for
/// the force that the ground around it exerts on the mass is m a (Seed & Martin 1966, J. Soil Mech. Found.
/// Div. ASCE 92(SM3), 25-58).
class SlidingMassOutput {
public:
  /// Adds the series to the file.
  SlidingMassOutput(const scene::Case& scene, results::RunWriter& writer);

  /// Writes a row of each series.
  void write_history(const Snapshot& snapshot, const Stepper& stepper);

  /// The series by their paths.
  const std::vector<std::pair<std::string, results::TimeSeries*>>& series() const { return series_; }

private:
  const scene::Case& scene_;
  std::vector<std::pair<std::string, results::TimeSeries*>> series_; ///< in the order of the case
};

} // namespace tremolo::mpm_domain
