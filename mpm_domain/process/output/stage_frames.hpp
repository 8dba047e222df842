#pragma once

// Frames of static stages. A model of one stage may have other soil and other structures than that of the
// shaking, so that each frame is a run of its own, "RUN/stages/2 NAME/run.h5", which pictures and Python read
// as they do others. It holds displacement and stress besides what the case asks for.

#include "mpm_domain/domain.hpp"
#include "scene/case.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace tremolo::mpm_domain {

/// The case with the model of a static stage, by its number (0 is gravity), before a later construction has
/// changed it, and without what is recorded in the model of the shaking.
scene::Case case_of_stage(const scene::Case& scene, std::size_t stage);

/// The folder of a stage's frame.
std::filesystem::path stage_folder(const std::filesystem::path& run, const scene::Case& scene,
                                   std::size_t stage);

/// Writes a domain that has not been shaken into FOLDER/run.h5. All ranks that share it call it.
/// @param scene   of its stage
/// @param reason  why the file has no more
void write_stage_frame(const std::filesystem::path& folder, const scene::Case& scene, Domain& domain,
                       const std::string& reason);

} // namespace tremolo::mpm_domain
