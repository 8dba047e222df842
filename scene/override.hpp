#pragma once

#include "scene/case.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace tremolo::scene {

/// What a run may replace in the motion of its case.
struct MotionOverride {
  std::optional<std::filesystem::path> record; ///< instead of [motion] file
  std::optional<double> angle_deg;             ///< instead of [motion] angle_deg
};

/// The text of the case with these values replaced and everything else, comments included, as it stands. Its
/// record has an absolute name, so that the text may be saved in another folder and means the same there. The
/// result is not checked: parse() it.
/// @throws std::invalid_argument for a record where the case has a pulse
std::string overridden_text(const Case& scene, const MotionOverride& values);

} // namespace tremolo::scene
