#pragma once

#include "mpm_domain/step/stepper.hpp"

namespace tremolo::test_support {

/// Makes a domain a free body, whose faces nothing pulls at and no dashpot holds.
/// @returns the source of a free field that nobody asks for
inline mpm_domain::FreeFieldSource no_traction(mpm_domain::Domain& domain) {
  domain.boundary.remove_faces();
  return {};
}

} // namespace tremolo::test_support
