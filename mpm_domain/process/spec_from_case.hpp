#pragma once

#include "mpm_domain/spec/spec.hpp"
#include "scene/case.hpp"

namespace tremolo::mpm_domain {

/// What the domain is built from, as the case says it.
Spec spec_from_case(const scene::Case& scene, int threads);

} // namespace tremolo::mpm_domain
