#pragma once

#include "scene/case.hpp"

#include <filesystem>
#include <vector>

namespace tremolo::scene {

/// The files of data that a case names, absolute: record of the motion, recorded free fields, curves of
/// soils. Every process of a run reads them.
std::vector<std::filesystem::path> data_files(const Case& scene);

} // namespace tremolo::scene
