#pragma once

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/spec/spec.hpp"
#include "scene/case.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// The spec of the domain that a case describes.
Spec spec_from_case(const scene::Case& scene, int threads);

/// The static stages after gravity, in their order.
std::vector<StaticStage> static_settings(const scene::Case& scene);

} // namespace tremolo::mpm_domain
