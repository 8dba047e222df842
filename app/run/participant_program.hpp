#pragma once

#include "scene/plan/plan.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tremolo::app {

/// The file of a program: ours lie beside this one; that of a user has a path of its own.
std::filesystem::path located(const std::string& program);

/// Arguments of a source besides the options that all participants have.
std::vector<std::string> own_arguments(const scene::FreeFieldModel& field);

} // namespace tremolo::app
