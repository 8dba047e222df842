#pragma once

#include "mesh/cell_size.hpp"
#include "mpm_domain/head/head.hpp"
#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/spec/lattice.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Side of the square of a particle in a cell of a level, m.
inline double particle_size(const Spec& spec, int level = 0) {
  return particle_size(mesh::cell_size(spec.cell_size, level), spec.particles_per_cell);
}

/// Lays particles on a square lattice aligned with the model box, particles_per_cell per cell and direction,
/// wherever the lattice point lies in a region. One set per soil, in the order of Spec::soils.
///
/// In a spec with structures or linings, squares are cut by these and by the edges of the regions: what is
/// left keeps its area, and its particle stands at its centroid.
///
/// On a graded mesh every leaf is filled alike, so that a particle's size goes with its cell; there is one
/// set per soil and level, level by level.
/// @param head  of the water of the spec; none without water
/// @throws std::invalid_argument if no particle results or the box is not a multiple of the particle size
std::vector<Particles> fill(const Spec& spec, const std::optional<Head>& head,
                            const mesh::Quadtree* tree = nullptr);

/// Gives particles the stress of level layers at rest: s_yy = -overburden of the particles above them, s_xx =
/// s_zz = K0 s_yy with the soil's nu/(1-nu); water that rises or falls through them takes part. A start for
/// the gravity stage, exact for level ground.
/// @param concerns  whether a particle, by set and number, gets the stress and weighs on others; none: all do
void set_rest_stress(std::span<Particles> sets, const Spec& spec,
                     const std::function<bool(std::size_t, std::size_t)>& concerns = {});

} // namespace tremolo::mpm_domain
