#pragma once

#include "mpm_domain/domain.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "results/run_file.hpp"
#include "scene/case.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// The part of a run's file about cuts through elastic structures: a series a section, with a row in each row
/// of the histories. Positions belong to the time of the velocities, half a step before the forces, as
/// particles and their stresses do (run_output.hpp).
class SectionOutput {
public:
  /// Adds the series to the file.
  SectionOutput(const scene::Case& scene, const Domain& domain, results::RunWriter& writer);

  /// Writes a row of each series.
  void write_history(const Stepper& stepper);

  /// The series by their paths.
  const std::vector<std::pair<std::string, results::TimeSeries*>>& series() const { return series_; }

private:
  const Domain& domain_;
  std::vector<std::pair<std::string, results::TimeSeries*>> series_; ///< in the order of Sections::all()
};

} // namespace tremolo::mpm_domain
