#pragma once

#include "materials/law/law.hpp"

namespace tremolo::materials {

/// CPU time of an update of one point while the soil is strongly shaken, ns, on one x86-64-v3 core: of soil
/// that yields now and then, and of sand that has liquefied (docs/performance.md).
double update_cost_ns(const Law& law);

} // namespace tremolo::materials
