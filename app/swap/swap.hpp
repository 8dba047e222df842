#pragma once

// Comparison of a case under several free-field models: the effect of the model's choice, and its cost.

#include "app/free_field/free_field_series.hpp"
#include "app/run/case_run.hpp"
#include "results/run_file.hpp"
#include "scene/case.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

/// Difference of two motions, sqrt(sum |v - r|^2 / sum |r|^2) over both components and all times, where v is
/// the particle velocity and r that of the reference.
struct Difference {
  std::string where; ///< monitor
  double relative_l2 = 0.0;
};

/// r_u at a monitor over the run.
struct PorePressureRatio {
  std::string where; ///< monitor
  double mean = 0.0;
  double rms_difference = 0.0; ///< to that of the first model
};

/// One model's run.
struct SwappedRun {
  scene::SourceModel model = scene::SourceModel::wave;
  std::string refused;              ///< why the case cannot take this model; empty if it ran to its end
  bool failed = false;              ///< it was taken, but its run failed
  std::vector<Difference> monitors; ///< to the first model that ran
  std::vector<PorePressureRatio> pore_pressure_ratio; ///< at the monitors that have pore pressure
  /// Relative L2 of the free field to that of the first model; of the worse side where the sides differ in
  /// ground or surface. None where either cannot be computed for itself.
  std::optional<double> free_field;
  std::optional<double>
      free_field_to_exact; ///< and to plane waves in the layers, where these can be computed
  double source_cpu_seconds = 0.0;
  double domain_cpu_seconds = 0.0;
  double wall_seconds = 0.0;
};

/// Runs the case with each model for both sides and the base, each in a folder of its name.
/// @param given   the case as read
/// @param run     how; its folder takes one folder a model
/// A run that fails is said in its entry, and the others go on.
/// @throws Exit where the user interrupts a run
std::vector<SwappedRun> swap_models(const scene::Case& given, const std::vector<scene::SourceModel>& models,
                                    const CaseRun& run);

/// The table for people.
std::string swap_text(const std::vector<SwappedRun>& runs);

/// That table as JSON, for the picture.
std::string swap_json(const std::vector<SwappedRun>& runs);

} // namespace tremolo::app
