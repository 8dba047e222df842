#pragma once

// Bounds that no free field can exceed. Ground near a fault moves at some m/s, and rock of 6 km/s bears 1.6
// GPa where it moves at 100 m/s. A value beyond the bounds here is a mistake of its source: a unit, or an
// integration that has blown up. It is refused where it enters, since the domain would blow up later and name
// itself.

#include "coupler/wire/field.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace tremolo::coupler {

/// The first value of a field that is not finite or beyond its bound, in words: its step, quantity, point and
/// the allowed range. Empty if all are plausible.
/// @param first_step  that the values begin with
/// @param values      steps x values_per_step() float64, not aligned
std::optional<std::string> implausible(const FieldDescription& field, std::uint64_t first_step,
                                       std::span<const std::byte> values);

} // namespace tremolo::coupler
