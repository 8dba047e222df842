#pragma once

// At the end of the static stages the memory of the laws begins with the stress that soil then has. A stress
// beyond the strength is returned to it. The vertical effective stress of wet soil, which pore pressure
// ratios are taken over, is that of this moment.

#include "mpm_domain/domain.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// Particles of a soil whose stress exceeded the strength and was returned to it.
struct CutStress {
  std::string soil;
  std::size_t particles = 0;
  Vector low, high; ///< corners of the box around them, m
};

/// The laws' memory begins with the stress under gravity, and with it the stiffness that the dashpots match.
/// Ranks that share the domain call it together.
/// @returns the soils whose law could not hold that stress
std::vector<CutStress> begin_history(Domain& domain);

} // namespace tremolo::mpm_domain
