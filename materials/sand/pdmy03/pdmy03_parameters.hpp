#pragma once

// Names of the parameters, in the order of parameters(const Pdmy03&).

#include <cstddef>
#include <string_view>

namespace tremolo::materials {

enum class Pdmy03Parameter : std::size_t {
  density,
  shear_modulus,
  bulk_modulus,
  friction,
  phase_transformation,
  contraction_a,
  contraction_b,
  contraction_c,
  contraction_d,
  contraction_e,
  dilation_a,
  dilation_b,
  dilation_c,
  peak_shear_strain,
  reference_pressure,
  pressure_exponent,
  surfaces,
  liquefaction_1,
  liquefaction_2,
  atmospheric_pressure,
  zero_pressure_strength,
  count
};

/// The name in the case file.
std::string_view pdmy03_name(Pdmy03Parameter parameter);

} // namespace tremolo::materials
