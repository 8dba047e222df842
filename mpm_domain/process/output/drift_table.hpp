#pragma once

#include "mpm_domain/boundary/drift/lost_hold.hpp"
#include "results/run_data.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// The table /drift of a run's file: how far the soil at its sides and its base has moved beyond the free
/// field by the end.
results::Table drift_table(std::span<const FaceDrift> faces);

} // namespace tremolo::mpm_domain
