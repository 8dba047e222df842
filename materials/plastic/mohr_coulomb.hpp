#pragma once

// Mohr-Coulomb with strain softening, tension positive, principal stresses s1 >= s2 >= s3:
//
//     f = (s1 - s3) + (s1 + s3) sin(phi) - 2 c cos(phi) <= 0,      s1 <= t  (optional tension cut-off),
//
// and the same form with the dilation angle psi as plastic potential. Cohesion and angles decay with the
// equivalent plastic deviatoric strain e = int sqrt(2/3 de^p : de^p),
//
//     x(e) = x_residual + (x_peak - x_residual) exp(-eta e),      x = c, phi, psi  (the angles themselves),
//
// after Feng, Wang, Huang & Jin (2021), Eng. Geol. 292, and Yerro et al. (2016), Geotechnique 66. Sources
// differ on whether phi or tan(phi) decays; here it is phi. The cut-off never lies above the apex, t <= c
// cot(phi).

#include "materials/elastic/elasticity.hpp"
#include "materials/law/parameter.hpp"
#include "materials/law/points.hpp"
#include "materials/law/state_variable.hpp"
#include "materials/law/strength_line.hpp"
#include "materials/law/traits.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::materials {

/// Parameters of the strain-softening Mohr-Coulomb law. State of a point: { equivalent_plastic_strain }.
struct MohrCoulomb {
  Elasticity elastic;
  double cohesion_peak = 0.0;                          ///< Pa
  double cohesion_residual = 0.0;                      ///< Pa
  double friction_peak = 0.0;                          ///< rad
  double friction_residual = 0.0;                      ///< rad
  double dilation_peak = 0.0;                          ///< rad
  double dilation_residual = 0.0;                      ///< rad
  double softening = 0.0;                              ///< eta, 1; 0 keeps the peak strength
  std::optional<double> tension_cutoff = std::nullopt; ///< largest tensile principal stress, Pa
};

/// The entry of a point's state block that holds the equivalent plastic deviatoric strain.
inline constexpr std::size_t equivalent_plastic_strain = 0;

Traits traits(const MohrCoulomb& law);

/// The state block of a point.
std::span<const StateVariable> state_variables(const MohrCoulomb& law);

std::vector<StrengthLine> strength_lines(const MohrCoulomb& law);

/// Advances stress, equivalent plastic strain and plastic work of all points by one step.
void update(const MohrCoulomb& law, const Points& points);

/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const MohrCoulomb& law);

/// What a file gives the law besides the elastic constants.
std::span<const LawField<MohrCoulomb>> fields(const MohrCoulomb& law);
/// With the tension cut-off, and the cell size for which softening holds.
std::span<const Parameter> mohr_coulomb_parameters();

std::vector<ParameterValue> parameters(const MohrCoulomb& law);

/// The soil held at its peak strength, e.g. for a gravity stage. Plastic strain still accumulates in the
/// state; who softens afterwards from the peak sets it back to zero first.
MohrCoulomb without_softening(MohrCoulomb law);

/// Divides strength by a factor: c/F and tan(phi)/F before and after softening. Dilation is unchanged, but
/// does not exceed friction. The apex keeps its position, and so does the tension cut-off.
/// @param factor  F, 1, > 0
std::optional<MohrCoulomb> with_reduced_strength(MohrCoulomb law, double factor);

/// Sand without cohesion and dilation.
/// @param friction  rad
MohrCoulomb cohesionless(const Elasticity& elastic, double friction);

/// The soil with eta scaled to cells of another size than those it was calibrated with: a shear band is about
/// one cell wide, so eta(h) = eta h / h_ref keeps shear strength against displacement across the band, and
/// with it the dissipated energy, independent of h.
/// @param cell_size, reference_size  h and h_ref, m
MohrCoulomb for_cell_size(MohrCoulomb law, double cell_size, double reference_size);

} // namespace tremolo::materials
