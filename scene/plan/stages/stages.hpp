#pragma once

// The stages of a case in their order: what a run goes through, by name.

#include "scene/case.hpp"

#include <string>
#include <vector>

namespace tremolo::scene {

struct PlannedStage {
  std::string name;
  std::string_view kind; ///< as the case has it
  std::string changes;   ///< what is other than in the stage before
  std::string lasts;     ///< how long, or until when
};

std::vector<PlannedStage> stages(const Case& scene);

/// A line for each stage.
std::string stages_text(const Case& scene);

} // namespace tremolo::scene
