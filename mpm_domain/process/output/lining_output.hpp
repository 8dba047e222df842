#pragma once

#include "mpm_domain/domain.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "results/run_file.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// The part of a run's file about linings: a series each, with a row in each row of the histories. A row
/// holds positions of the nodes of the axis, section forces in the middle of each element, and what soil
/// presses and shears on each segment of the outer face. Positions belong to the time of the velocities, half
/// a step before the section forces, as particles and their stresses do (run_output.hpp).
class LiningOutput {
public:
  /// Adds the series to the file.
  LiningOutput(const Domain& domain, results::RunWriter& writer);

  /// Writes a row of each series.
  void write_history(const Stepper& stepper);

  /// The series by their paths.
  const std::vector<std::pair<std::string, results::TimeSeries*>>& series() const { return series_; }

private:
  const Domain& domain_;
  std::vector<std::pair<std::string, results::TimeSeries*>> series_; ///< in the order of Linings::bodies()
};

} // namespace tremolo::mpm_domain
