#pragma once

// The stress of level layers at rest, with which the way to rest begins: exact for level ground. The
// particles in a column, as wide as the smallest of them, weigh on those below,
//
//     s_yy = -(sum of the weights above + half of its own) / width,      s_xx = s_zz = K0 s_yy,
//
// with the soil's K0 = nu/(1 - nu). A particle stands in all columns that it covers, and takes the mean of
// their overburdens. Water that rises or falls through soil takes part. What lies under a lining has borne
// the soil that stood in its place.

#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <cstddef>
#include <functional>
#include <span>

namespace tremolo::mpm_domain {

class Communicator;

/// Gives particles this stress.
/// @param concerns  whether a particle, by set and number, gets the stress and weighs on others; none: all do
/// @param ranks     those that have particles of the same columns, each its own; all call it. Null: there are
///                  no others
void set_rest_stress(std::span<Particles> sets, const Spec& spec,
                     const std::function<bool(std::size_t, std::size_t)>& concerns = {},
                     Communicator* ranks = nullptr);

} // namespace tremolo::mpm_domain
