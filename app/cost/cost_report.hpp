#pragma once

// Results of `tremolo cost`, and cost.json, from which the tables and the picture are made.

#include "app/cost/cost_front.hpp"
#include "app/study/variant.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

/// A rung and what became of it.
struct CostRung {
  Variant variant;
  bool reference = false; ///< the others are held against it
  CostPoint point{};
  double phase_lag = 0.0; ///< s, positive where the run is late
  bool front = false;     ///< it lies on the Pareto front

  bool measured() const { return variant.scene && !reference; }
};

/// The cheapest setting that a fit expects to reach the target.
struct CostPrediction {
  CostFit fit;
  double size = 0.0; ///< m, one that the case takes
};

struct CostStudy {
  std::string title;
  std::vector<scene::Axis> knobs;
  std::vector<CostRung> rungs;
  std::string error_of{};         ///< what the errors are relative to, in words
  std::vector<CostFit> fits{};    ///< of the rungs that have an error
  std::optional<double> target{}; ///< 1
  std::optional<CostPrediction> prediction{};

  /// Points of the rungs that have an error.
  std::vector<CostPoint> points() const;
};

std::string cost_json(const CostStudy& study);

} // namespace tremolo::app
