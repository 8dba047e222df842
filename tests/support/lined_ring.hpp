#pragma once

// A circular lining 0.3 m thick whose axis is a circle of 3 m about the origin.

#include "mpm_domain/lining/lining_contact.hpp"
#include "tests/support/beam_ring.hpp"

namespace tremolo::test_support {

/// @param corners  of its outline, a polygon with the area of the circle
inline mpm_domain::Lining ring_lining(std::size_t corners = 64) {
  const double outer = (ring_radius + 0.5 * ring_thickness) / ring_radius;
  mpm_domain::Lining lining{.name = "ring",
                            .outline = ring_shape(corners).nodes,
                            .thickness = ring_thickness,
                            .section = ring_section,
                            .hinges = {},
                            .friction = {},
                            .adhesion = {}};
  for (Vector& corner : lining.outline)
    corner = {outer * corner.x, outer * corner.y};
  return lining;
}

} // namespace tremolo::test_support
