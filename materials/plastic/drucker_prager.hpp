#pragma once

// Drucker-Prager: a circular cone about the hydrostatic axis, tension positive, with p = tr(sigma)/3,
// s = dev(sigma), q = sqrt(s:s/2):
//
//     f = q + eta p - xi c <= 0,      plastic potential q + eta' p,      apex p = xi c/eta = c cot(phi).
//
// The constants make it agree with Mohr-Coulomb of cohesion c, friction angle phi and dilation angle psi in
// one condition (Chen & Mizuno 1990, Nonlinear Analysis in Soil Mechanics, ch. 4; de Souza Neto, Peric & Owen
// 2008, Computational Methods for Plasticity, ch. 6):
//
//     triaxial compression   eta = 6 sin(phi)/(sqrt(3) (3 - sin(phi)))
//     triaxial extension     eta = 6 sin(phi)/(sqrt(3) (3 + sin(phi)))
//     plane strain           eta = sin(phi)/(sqrt(1 - eta'^2/3) + eta' sin(phi)/3)
//     all                    xi = eta cot(phi),   eta' like eta with psi for phi and associated flow
//
// In plane strain the out-of-plane stress at the limit load follows from the flow rule, so that eta depends
// on psi; for psi = phi it is the usual 3 tan(phi)/sqrt(9 + 12 tan^2(phi)), and the in-plane flow has the
// dilation angle psi. Away from the matched condition the cone is not Mohr-Coulomb: see the closed forms of
// its strength in the tests.

#include "base/words.hpp"
#include "materials/elastic/elasticity.hpp"
#include "materials/law/parameter.hpp"
#include "materials/law/points.hpp"
#include "materials/law/state_variable.hpp"
#include "materials/law/strength_line.hpp"
#include "materials/law/traits.hpp"

#include <optional>
#include <span>
#include <vector>

namespace tremolo::materials {

/// The condition in which the cone has the strength of Mohr-Coulomb.
enum class ConeMatch { triaxial_compression, triaxial_extension, plane_strain };
constexpr auto words(ConeMatch) {
  return word_table<ConeMatch>({{ConeMatch::triaxial_compression, "triaxial_compression"},
                                {ConeMatch::triaxial_extension, "triaxial_extension"},
                                {ConeMatch::plane_strain, "plane_strain"}});
}

/// Parameters of the Drucker-Prager law. State of a point: { equivalent_plastic_strain }.
struct DruckerPrager {
  Elasticity elastic;
  double cohesion = 0.0; ///< Pa
  double friction = 0.0; ///< rad
  double dilation = 0.0; ///< rad, at most the friction angle
  ConeMatch match = ConeMatch::plane_strain;
};

/// Divides strength by a factor: c/F and tan(phi)/F. Dilation is unchanged, but does not exceed friction.
/// @param factor  F, 1, > 0
std::optional<DruckerPrager> with_reduced_strength(DruckerPrager law, double factor);

/// Clay that yields at its undrained strength whatever the pressure: a cone without friction, which in plane
/// strain is von Mises' and Tresca's criterion alike.
/// @param strength  s_u, Pa
DruckerPrager frictionless(const Elasticity& elastic, double strength);

/// The constants of the cone.
struct Cone {
  double slope = 0.0;     ///< eta, 1
  double strength = 0.0;  ///< xi c, Pa: q at p = 0
  double dilatancy = 0.0; ///< eta', 1
  double apex = 0.0;      ///< c cot(phi), Pa; infinite for phi = 0
};

Cone cone(const DruckerPrager& law);

Traits traits(const DruckerPrager& law);

/// The state block of a point.
std::span<const StateVariable> state_variables(const DruckerPrager& law);

std::vector<StrengthLine> strength_lines(const DruckerPrager& law);

/// Advances stress, equivalent plastic strain and plastic work of all points by one step.
void update(const DruckerPrager& law, const Points& points);

/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const DruckerPrager& law);

/// What a file gives the law besides the elastic constants and the cone.
std::span<const LawField<DruckerPrager>> fields(const DruckerPrager& law);

std::vector<ParameterValue> parameters(const DruckerPrager& law);

} // namespace tremolo::materials
