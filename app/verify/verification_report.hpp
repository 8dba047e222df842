#pragma once

#include "app/verify/verification.hpp"

#include <filesystem>
#include <string>

namespace tremolo::app {

/// Whether the relative L2 error of the whole domain is within the tolerance of the case.
bool passed(const Verification& verification, const scene::Case& scene);

/// The table that the command prints.
std::string text(const Verification& verification, const scene::Case& scene);

/// Refuses a run whose verification would be written over a file of somebody else.
/// @throws std::runtime_error naming it
void require_report_writable(const std::filesystem::path& run_file);

/// Writes verify.json and verify.h5 (docs/output-format.md) beside the run file.
/// @throws std::runtime_error where they cannot be written
void write_report(const Verification& verification, const scene::Case& scene,
                  const std::filesystem::path& run_file);

} // namespace tremolo::app
