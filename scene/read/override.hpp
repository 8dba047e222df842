#pragma once

#include "scene/case.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace tremolo::scene {

/// A free field of a recorded exchange.
struct RecordedSide {
  std::filesystem::path file;
  Side side = Side::left;
};

/// The parts of a case that a run may replace.
struct CaseOverride {
  std::optional<std::filesystem::path> record; ///< instead of [motion] file
  std::optional<double> angle_deg;             ///< instead of [motion] angle_deg
  std::optional<SourceModel> model;            ///< instead of the model of both sides and the base
  std::map<Side, RecordedSide> replays{};      ///< recordings instead of the models of these sides
};

/// The text of the case with these values replaced and everything else, comments included, as it stands; a
/// new model takes the place of the old one's file, side or program too. The files it names have absolute
/// names, so that the text may be saved in another folder and means the same there. The result is not
/// checked: parse() it.
/// @throws std::invalid_argument for a record where the case has a pulse
std::string overridden_text(const Case& scene, const CaseOverride& values);

} // namespace tremolo::scene
