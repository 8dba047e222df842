#pragma once

#include "mpm_domain/domain.hpp"

namespace tremolo::test_support {

/// act(set, k) for every particle of a domain.
template <typename Act>
void for_particles(mpm_domain::Domain& domain, const Act& act) {
  for (mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      act(set, k);
}

} // namespace tremolo::test_support
