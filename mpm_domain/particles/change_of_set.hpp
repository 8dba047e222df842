#pragma once

// Particles leave their set, and come to that of another size (splitting.hpp) or to that of ground which they
// are placed on (earthworks/earthworks.hpp).

#include "mpm_domain/particles/particles.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::mpm_domain {

/// Adds to another set what a quarter of a particle takes over from it by the table of fields, with an id of
/// its own there; fields that move are copied.
void add_quarter(const Particles& from, std::size_t k, Particles& to);

/// Adds a copy of a particle to a set with the same fields, with an id of its own there.
void add_copy(const Particles& from, std::size_t k, Particles& to);

/// Takes the particles of these indices, in rising order and at least one, out of a set.
void remove(Particles& p, const std::vector<std::size_t>& gone);

} // namespace tremolo::mpm_domain
