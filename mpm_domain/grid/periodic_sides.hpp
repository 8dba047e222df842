#pragma once

// Periodic sides, exactly: the domain repeats itself along x with the period L = x_max - x_min, a whole
// number of cells n. Node columns i and i + n are one; the columns outside the period's n are images, which
// particles near a side reach. What they collect is added to the columns they stand for, and what those do is
// copied back. Particles may stand beyond a side until the next sort takes them back by L.

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

/// Takes particles that have left the period back into it; displacements stay as they are.
void wrap(Particles& particles, const Box& box);

} // namespace tremolo::mpm_domain
