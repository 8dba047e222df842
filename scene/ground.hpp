#pragma once

#include "scene/case.hpp"

namespace tremolo::scene {

/// The ground of a case for work that makes its motion: as load_free_field(), but the record that [motion]
/// names need not be there yet.
/// @throws CaseErrors with every error of these tables
Case load_ground(const std::filesystem::path& file, SourceModel model);

} // namespace tremolo::scene
