#pragma once

#include "materials/relaxation/relaxation.hpp"

namespace tremolo::materials {

/// Where a damping ratio is to be constant, and by how many relaxation mechanisms.
struct DampingBand {
  double lowest_hz = 0.1;
  double highest_hz = 25.0;
  int mechanisms = 4;
};

/// Damping whose ratio hardly depends on frequency in a band.
struct ConstantDamping {
  double reference_hz = 0.0; ///< at which the modulus G* has the magnitude of the soil's G
  DampingBand band = {};
};

/// @throws std::invalid_argument naming quantity, value and the allowed range
void validate(const ConstantDamping& damping);

/// The mechanisms that give soil a damping ratio, Im G*/Re G* = 2 ratio, over the band; none for a ratio of
/// 0.
/// @param ratio  of critical, in [0, 1); throws std::invalid_argument as validate(), and for another
Relaxation relaxation(const ConstantDamping& damping, double ratio);

/// By how much, relative to it, the ratio is off at most in the band; the same for every ratio.
double worst_error_of_ratio(const DampingBand& band);

} // namespace tremolo::materials
