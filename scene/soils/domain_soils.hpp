#pragma once

#include "scene/case.hpp"

#include <functional>
#include <vector>

namespace tremolo::scene {

/// The soils that lie in the domain, in the order of the case; others belong to layers of the free field
/// alone.
std::vector<std::reference_wrapper<const Soil>> domain_soils(const Case& scene);

} // namespace tremolo::scene
