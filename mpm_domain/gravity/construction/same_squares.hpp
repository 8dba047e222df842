#pragma once

// Two models are laid on one lattice of squares, so that soil is the same in both where a particle of its
// kind stands in the same square. Where ranks share the models, each of these deals its tiles out by itself.
// The ranks then meet by columns of squares: one rank for each column learns which ranks have a square of
// either model, and lets particles of the one go where the other has their square.

#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <cstddef>
#include <functional>

namespace tremolo::mpm_domain {

class Communicator;

/// Takes particle j of a set for particle k, which stands in its square.
using TakeFormer = std::function<void(std::size_t k, const Particles& from, std::size_t j)>;

/// Finds the particles of a set in the squares of another one. All ranks call it.
/// @param set     of the model after, with squares of the same size
/// @param former  of the model before, at the positions at which it was laid
/// @param box     of both models
/// @param ranks   that share the models; null: there is one process
void meet_in_squares(const Particles& set, const Particles& former, const Box& box, Communicator* ranks,
                     const TakeFormer& take);

} // namespace tremolo::mpm_domain
