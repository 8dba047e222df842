#pragma once

#include "mpm_domain/head/head.hpp"
#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <optional>
#include <vector>

namespace tremolo::mpm_domain {

/// Lays the particles of the elastic structures on the square lattice of the soil's finest particles. Squares
/// are cut by the outline and the hole; what is left keeps its area, and its particle stands at its centroid.
/// All together have the mass of the structure.
/// One set per structure, and another for what of it lies below the water table and weighs less by the water
/// that it displaces; in the order of Spec::structures.
/// @param finest  level of the finest cells
/// @throws std::invalid_argument for a structure that no particle lies in, or without a valid stiffness
std::vector<Particles> fill_bodies(const Spec& spec, const std::optional<Head>& head, int finest);

} // namespace tremolo::mpm_domain
