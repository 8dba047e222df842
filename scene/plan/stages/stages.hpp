#pragma once

// The stages of a case in their order: what a run goes through, by name.

#include "scene/case.hpp"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tremolo::scene {

struct PlannedStage {
  std::string name;
  std::string_view kind; ///< as the case has it
  std::string changes;   ///< what is other than in the stage before
  std::string lasts;     ///< how long, or until when
};

/// Five periods 4 H/c_s of ground as deep as the mesh and all of its slowest soil, s.
double slow_ramp(const Case& scene);
/// The time in which a change of a static stage grows, s.
double ramp_of(const Case& scene, const StaticStage& stage);

/// A stage between gravity and the shaking.
using BeforeShaking = std::variant<const LoadStage*, const ConstructionStage*>;
/// All of them in their order; they point into the case.
std::vector<BeforeShaking> static_stages(const Case& scene);
/// The case with the model as it was before a construction, and the loads of that time.
Case before_construction(const Case& scene, const ConstructionStage& construction);
/// The case with the model of a static stage, by its number (0 is gravity): that before the next
/// construction.
Case model_of_stage(const Case& scene, std::size_t stage);

/// The case with the model as an earthwork after a shaking leaves it.
Case after_earthwork(const Case& scene, const Earthwork& work);

std::vector<PlannedStage> stages(const Case& scene);

/// A line for each stage.
std::string stages_text(const Case& scene);

} // namespace tremolo::scene
