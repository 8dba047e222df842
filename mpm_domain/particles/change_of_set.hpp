#pragma once

// Particles leave their set and come to that of another size (splitting.hpp).

#include "mpm_domain/particles/particles.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::mpm_domain {

/// Adds a copy of a particle to another set, with an id of its own there.
void add_copy(const Particles& from, std::size_t k, Particles& to);

/// Takes the particles of these places, in rising order and at least one, out of a set.
void remove(Particles& p, const std::vector<std::size_t>& gone);

} // namespace tremolo::mpm_domain
