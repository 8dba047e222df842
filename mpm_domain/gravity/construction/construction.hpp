#pragma once

// A construction stage exchanges the model for another one. Particles that stand in the same square of the
// same soil, or of the same structure, keep stress, state, pore pressure and displacement; others are gone or
// new. New soil begins with the stress of its own weight,
//
//     s_yy = -gamma (depth below the top of what is placed with it),      s_xx = s_zz = K0 s_yy,
//
// so that a lift does not settle under itself. Forces of soil on nodes are then no longer those before, f0,
// but f1, and
//
//     c = f0 - f1
//
// is what the nodes lack: what removed soil held, less the weight of placed soil. With c as a load nothing
// moves, and as it goes to zero (relaxation.hpp) the ground takes over: excavation and placing are one. What
// a removed structure pressed onto the soil counts in f0. A placed one begins without weight. Where the water
// has another level, soil that becomes dry, or wet, weighs otherwise, and so c has that part too; what it
// presses with on linings goes from one model's to the other's along the same share.

#include "mpm_domain/domain.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Gives the particles and linings of a model what those of the model before have come to, and new soil the
/// stress of its own weight. All ranks that share the models call it.
void carry_over(const Domain& before, Domain& after);

/// The bodies that are not among the structures of the model after, as indices into Contact::bodies().
std::vector<std::size_t> removed_structures(const Domain& before, const std::vector<Structure>& after);

/// c of the nodes of the model after; a placed body begins without forces.
/// @param f0, f1  forces on the nodes of the model before and of that after, N/m
std::vector<Vector> lacking_forces(const Domain& before, const Domain& after, const std::vector<Vector>& f0,
                                   const std::vector<Vector>& f1);

/// Weight and buoyancy, in the model before, of the structures of the one after, with what props and
/// structures that go did to them; none of one that is placed. Of ranks, the first has structures.
/// @param of_going  what structures that go did, by body of the model before
std::vector<RigidLoad> weights_before(const Domain& before, const Domain& after,
                                      std::span<const RigidLoad> of_going);

} // namespace tremolo::mpm_domain
