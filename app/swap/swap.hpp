#pragma once

// Comparison of a case under several free-field models: the effect of the model's choice, and its cost.

#include "app/study/variant.hpp"
#include "scene/case.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

/// r_u over a run.
struct PorePressureRatio {
  double mean = 0.0;
  double rms_difference = 0.0; ///< to that of the first model that ran
};

struct AtMonitor {
  std::string name;
  double difference = 0.0;                ///< of the velocity, relative to that of the first model that ran
  std::optional<PorePressureRatio> ratio; ///< none where there is no pore pressure
};

/// One model's run. Free fields of sides that differ in ground or surface are compared at the worse one.
struct SwappedRun {
  Variant variant;
  bool failed = false; ///< it is a case, but its run failed
  RunCost cost{};
  std::vector<AtMonitor> monitors{};
  std::optional<double> free_field{}; ///< relative to that of the first model; none where one is not known
  std::optional<double> free_field_to_exact{}; ///< and to plane waves in the layers

  const std::string& model() const { return variant.name; }
  bool ran() const { return variant.refused.empty(); }
};

/// Runs the case with each model for both sides and the base, each in a folder of its name. A run that fails
/// says so in its entry, and the others go on.
/// @param given  the case as read
/// @param out    takes one folder a model
/// @throws Exit where the user interrupts a run
std::vector<SwappedRun> swap_models(const scene::Case& given, const std::vector<scene::SourceModel>& models,
                                    const std::filesystem::path& out, int threads);

/// The comparison as JSON.
std::string swap_json(const std::vector<SwappedRun>& runs);

} // namespace tremolo::app
