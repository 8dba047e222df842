#pragma once

#include "scene/case.hpp"

#include <optional>

namespace tremolo::scene {

/// The ground of a case for work that makes its motion: as load_free_field(), but the record that [motion]
/// names need not be there yet.
/// @param side  with one, the tables of both sides are read too: their surfaces, and layers of their own
/// @throws CaseErrors with every error of these tables
Case load_ground(const std::filesystem::path& file, SourceModel model, std::optional<Side> side);

} // namespace tremolo::scene
