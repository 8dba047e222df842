#pragma once

#include "mesh/cell_size.hpp"
#include "mpm_domain/head/head.hpp"
#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/spec/lattice.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace tremolo::mpm_domain {

class Communicator;

/// Side of the square of a particle in a cell of a level, m.
inline double particle_size(const Spec& spec, int level = 0) {
  return particle_size(mesh::cell_size(spec.cell_size, level), spec.particles_per_cell);
}

/// The message that refuses a spec without particles.
inline constexpr const char* no_particle = "no particle lies in any region: the domain is empty";

/// Lays particles on a square lattice aligned with the model box, particles_per_cell per cell and direction,
/// wherever the lattice point lies in a region. One set per soil, in the order of Spec::soils. A set's
/// particles have the numbers 0, 1, ... in the order in which they are laid.
///
/// In a spec with structures or linings, squares are cut by these and by the edges of the regions: what is
/// left keeps its area, and its particle stands at its centroid. Slivers join the nearest particle.
///
/// On a graded mesh every leaf is filled alike, so that a particle's size goes with its cell; there is one
/// set per soil and level, level by level.
/// @param head   of the water of the spec; none without water
/// @param ranks  those that fill it together, all of which call it: each fills a part of the rows of lattice
///               points, or of the leaves of a graded mesh. Null: all is filled here
/// @throws std::invalid_argument if the box is not a multiple of the particle size, or one process fills all
/// and no particle results
std::vector<Particles> fill(const Spec& spec, const std::optional<Head>& head,
                            const mesh::Quadtree* tree = nullptr, Communicator* ranks = nullptr);

} // namespace tremolo::mpm_domain
