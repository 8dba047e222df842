#pragma once

// Strain-dependent shear modulus and damping of soil, G/Gmax and D against the amplitude of the engineering
// shear strain: a table of one's own, or the curves of Darendeli (2001), "Development of a new family of
// normalized modulus reduction and material damping curves", PhD thesis, University of Texas at Austin,
// chapter 9, with gamma in per cent, sigma' in atm, D in per cent:
//
//     G/Gmax   = 1 / (1 + (gamma/gamma_r)^a),   gamma_r = (phi1 + phi2 PI OCR^phi3) sigma'^phi4,   a = phi5
//     D        = b (G/Gmax)^0.1 D_masing + D_min,   b = phi11 + phi12 ln N
//     D_min    = (phi6 + phi7 PI OCR^phi8) sigma'^phi9 (1 + phi10 ln f)
//     D_masing = c1 D1 + c2 D1^2 + c3 D1^3,   D1 the Masing damping of the hyperbola (a = 1)

#include <span>
#include <vector>

namespace tremolo::materials {

/// G/Gmax and damping ratio at given shear strain amplitudes (ratios, not per cent).
struct SoilCurves {
  std::vector<double> strain;        ///< strictly increasing, in (0, 1]
  std::vector<double> modulus_ratio; ///< G/Gmax, in (0, 1], not increasing
  std::vector<double> damping_ratio; ///< in [0, 1]

  /// Linear in the logarithm of the strain; the first and last values hold outside of the table.
  double modulus_ratio_at(double amplitude) const;
  double damping_ratio_at(double amplitude) const;
};

/// Refuses a table that is empty, ragged, out of order or out of range.
/// @throws std::invalid_argument naming the row, the value and the allowed range
void validate(const SoilCurves& curves);

/// Parameters of the curves of Darendeli (2001).
struct Darendeli {
  double plasticity_index = 0.0;        ///< PI, per cent
  double overconsolidation_ratio = 1.0; ///< OCR
  double mean_effective_stress = 0.0;   ///< sigma', Pa, compression positive
  double frequency = 1.0;               ///< f, Hz
  double cycles = 10.0;                 ///< N

  /// gamma_r, a ratio
  double reference_strain() const;
  /// Damping at vanishing strain
  double least_damping() const;
  double modulus_ratio_at(double amplitude) const;
  double damping_ratio_at(double amplitude) const;
};

/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const Darendeli& soil);

/// The curves at given strains; by default 10 a decade from 1e-6 to 0.1.
/// @throws std::invalid_argument for parameters or strains outside their range
SoilCurves darendeli_curves(const Darendeli& soil, std::span<const double> strains = {});

} // namespace tremolo::materials
