#pragma once

#include "materials/relaxation/relaxation.hpp"

namespace tremolo::materials {

/// Frequency band in which a damping ratio is constant, and the number of relaxation mechanisms.
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

/// Largest relative error of the ratio in the band, equal for all ratios.
double worst_error_of_ratio(const DampingBand& band);

} // namespace tremolo::materials
