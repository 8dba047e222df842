#pragma once

// Plan of a sweep: the checked case of every combination, and the properties known before it runs.

#include "app/study/design.hpp"
#include "motion/measures.hpp"
#include "scene/case.hpp"
#include "scene/study.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

/// One run of a sweep.
struct SweepRun {
  Combination values;
  std::optional<scene::SourceModel> model; ///< of a site response; none: a domain runs
  std::string text;                        ///< of the case
  std::string recording_text; ///< of the case that also records its exchange; empty of a site response
  std::string inputs;         ///< files of data that it reads, with their checksums
  std::string free_fields;    ///< all that they depend on; empty where nobody else can use them
  std::optional<motion::Measures>
      motion; ///< of the incident wave while the run lasts; nothing if there is none
};

/// @param axes  of the study, with the motions that were made for it
/// @throws scene::CaseErrors with all that is wrong with the axes and their values, at their places in the
/// study
std::vector<SweepRun> planned_runs(const scene::Study& study, const std::vector<scene::Axis>& axes,
                                   const scene::Case& given);

/// The case of a study as its runs read it: complete, or for site responses its ground and motion alone.
/// @throws scene::CaseErrors
scene::Case case_of(const scene::Study& study);

/// Refuses monitors of the study that the case does not have.
/// @throws scene::CaseErrors
void require_monitors(const scene::Study& study, const scene::Case& given);

/// Writes the plan into the folder of the sweep: sweep.json, and cases/NNNN.toml for each run. A run that an
/// earlier plan there has, by the text of its case, keeps its number.
void write_plan(const scene::Study& study, const std::vector<scene::Axis>& axes, const scene::Case& given,
                const std::vector<SweepRun>& runs, const std::filesystem::path& folder);

} // namespace tremolo::app
