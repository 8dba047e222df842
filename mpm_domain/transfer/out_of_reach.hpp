#pragma once

#include "mpm_domain/particles/particles.hpp"

#include <cstddef>
#include <stdexcept>

namespace tremolo::mpm_domain {

/// A particle or a structure that has come to where the step does not know how to go on with it. The message
/// names it and its place; the stepper adds time and step.
struct OutOfReach : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A particle that is not where it may be by the last sort.
/// @param way  that particles may go from one sort to the next, m
/// @throws OutOfReach
[[noreturn]] void refuse_stray(const Particles& p, std::size_t k, double way);

} // namespace tremolo::mpm_domain
