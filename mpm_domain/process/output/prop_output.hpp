#pragma once

#include "mpm_domain/domain.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "results/run_file.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// The part of a run's file about props: a series a prop, with a row in each row of the histories. Force and
/// positions lie half a step after the time of the row, as stresses do (run_output.hpp).
class PropOutput {
public:
  /// Adds the series to the file.
  PropOutput(const Domain& domain, results::RunWriter& writer);

  /// Writes a row of each series.
  void write_history(const Stepper& stepper);

  /// The series by their paths.
  const std::vector<std::pair<std::string, results::TimeSeries*>>& series() const { return series_; }

private:
  const Domain& domain_;
  std::vector<std::pair<std::string, results::TimeSeries*>> series_; ///< in the order of Props::all()
};

} // namespace tremolo::mpm_domain
