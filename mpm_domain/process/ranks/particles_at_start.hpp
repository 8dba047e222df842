#pragma once

#include "mpm_domain/domain.hpp"
#include "scene/case.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// The particles that output looks for at the start of shaking, of a domain that ranks share: those nearest
/// to monitors and to the points of lines and all around them, those of the boundary's faces, and those of
/// elastic bodies. All ranks call it; the first gets the domain's sets with these particles, the others get
/// nothing.
std::vector<Particles> particles_at_start(const Domain& domain, const scene::Case& scene);

} // namespace tremolo::mpm_domain
