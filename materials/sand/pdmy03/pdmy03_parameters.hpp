#pragma once

// The table of PDMY03's parameters, in the order of parameters(const Pdmy03&).

#include "materials/sand/pdmy03/pdmy03.hpp"

#include <cstddef>
#include <span>

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
  zero_pressure_strength
};

/// How far cyclic strength confirms an entry of the recommended sets.
enum class Pdmy03Evidence { published, strength, none };

struct Pdmy03Row {
  Parameter text;
  std::optional<double>& (*input)(Pdmy03Input&);
  double (*value)(const Pdmy03&);
  double fallback = 0.0; ///< as the law has it; of those that are in no recommended set
  Pdmy03Evidence evidence = Pdmy03Evidence::published;
};

std::span<const Pdmy03Row> pdmy03_rows();

inline const Pdmy03Row& row(Pdmy03Parameter parameter) {
  return pdmy03_rows()[static_cast<std::size_t>(parameter)];
}

} // namespace tremolo::materials
