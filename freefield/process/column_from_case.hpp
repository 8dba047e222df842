#pragma once

#include "freefield/column.hpp"
#include "freefield/process/incident_wave.hpp"
#include "scene/case.hpp"
#include "scene/plan.hpp"

#include <memory>

namespace tremolo::freefield {

/// The column of a source: the layers of the case under the source's surface, and soil of the half-space
/// below them where they end above the base of the model.
/// @param incident must outlive the column
std::unique_ptr<Column> column_from_case(const scene::Case& scene, const scene::SourceProcess& source,
                                         const IncidentWave& incident);

} // namespace tremolo::freefield
