#pragma once

#include "mpm_domain/domain.hpp"
#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"

#include <algorithm>
#include <vector>

namespace tremolo::test_support {

/// -K u of an elastic domain without stress, by its own passes: puts the nodal forces (N/m) of displacements
/// u (m) into the grid, which stand in the grid's velocities after the update. Keep them so small that
/// volumes stay as they are.
inline void elastic_forces(mpm_domain::Domain& domain) {
  mpm_domain::prolong(domain, mpm_domain::NodeGroup::velocity);
  for (mpm_domain::Particles& p : domain.sets)
    for (std::vector<double>* stress : {&p.sxx, &p.syy, &p.szz, &p.sxy})
      std::ranges::fill(*stress, 0.0);
  mpm_domain::gather(domain, 1.0, {.strain = true});
  mpm_domain::scatter(domain, mpm_domain::ScatterPart::force);
}

} // namespace tremolo::test_support
