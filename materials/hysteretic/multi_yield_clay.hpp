#pragma once

// Clay under undrained loading, in total stress: nested von Mises surfaces with kinematic hardening (Iwan
// 1967, Mroz 1967, Prevost 1977), independent of pressure,
//
//     sigma = sigma_m I + sum_i s_i,   d sigma_m = K tr(d_eps),   sqrt(s_i : s_i / 2) <= tau_i,
//     sum_i tau_i = s_u.
//
// They are the parallel elements of iwan_elements.hpp, on a curve that reaches the undrained shear strength
// s_u exactly at the peak strain gamma_p and is level beyond. Without a curve of the user's it is the
// hyperbola through that point,
//
//     tau = G gamma/(1 + gamma/gamma_r),   gamma_r = gamma_p s_u/(G gamma_p - s_u).
//
// Unlike IwanShear the elements carry the whole deviatoric stress, the initial one included, as if it had
// been reached by monotonic loading: s_u bounds the total shear stress, static shear included. A von Mises
// strength is s_u in simple shear and any plane strain, s1 - s3 = 2 s_u there and sqrt(3) s_u in triaxial
// tests.

#include "materials/elastic/elasticity.hpp"
#include "materials/elastic/linear_elastic.hpp"
#include "materials/hysteretic/backbone/curves.hpp"
#include "materials/hysteretic/iwan_elements.hpp"
#include "materials/law/parameter.hpp"
#include "materials/law/points.hpp"
#include "materials/law/state_variable.hpp"
#include "materials/law/strength_line.hpp"
#include "materials/law/traits.hpp"
#include "materials/plastic/drucker_prager.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::materials {

/// Clay of nested yield surfaces. State of a point: the elements' stresses, as in iwan_elements.hpp.
struct MultiYieldClay {
  Elasticity elastic;                ///< at small strain; Poisson's ratio near 0.5 for saturated clay
  double undrained_strength = 0.0;   ///< s_u, Pa
  double peak_strain = 0.0;          ///< gamma_p, 1
  std::vector<IwanElement> elements; ///< one a yield surface, in order of growing yield strain
};

/// Resolution and range of the surfaces' fit to the curve.
struct ClaySurfaces {
  std::size_t count = 20;   ///< a multiple of iwan_group
  double peak_strain = 0.1; ///< engineering shear strain at which s_u is reached
};

/// Clay whose hyperbola is fixed by G = elastic.shear_modulus(), s_u (Pa) and the peak strain.
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
MultiYieldClay multi_yield_clay(const Elasticity& elastic, double undrained_strength,
                                const ClaySurfaces& surfaces = {});

/// Clay with a yield surface at every point of a modulus reduction curve (damping is not used), as far as its
/// stress lies below s_u; from there straight to s_u at the peak strain.
/// @throws std::invalid_argument also for a curve whose stress is not concave in the strain
MultiYieldClay multi_yield_clay(const Elasticity& elastic, double undrained_strength,
                                const SoilCurves& curves, double peak_strain = 0.1);

/// Shear stress under monotonic simple shear from isotropic stress, Pa.
double monotonic_stress(const MultiYieldClay& law, double strain);

Traits traits(const MultiYieldClay& law);

/// The state block of a point.
std::span<const StateVariable> state_variables(const MultiYieldClay& law);

std::vector<StrengthLine> strength_lines(const MultiYieldClay& law);

/// The elastic soil to make an initial stress with: memory begins with that stress.
LinearElastic without_softening(const MultiYieldClay& law);

/// The clay at its strength s_u/F, to which it is elastic: a limit load does not depend on the curve.
std::optional<DruckerPrager> with_reduced_strength(const MultiYieldClay& law, double factor);

/// Spreads the deviatoric stress over the elements as monotonic loading does; a stress beyond the strength is
/// scaled back to it.
void initialise(const MultiYieldClay& law, const Points& points);

/// Advances stress, element stresses and plastic work of all points by one step.
void update(const MultiYieldClay& law, const Points& points);

/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const MultiYieldClay& law);

/// What a file gives the law besides the elastic constants and a curve.
std::span<const Parameter> multi_yield_clay_parameters();

std::vector<ParameterValue> parameters(const MultiYieldClay& law);

} // namespace tremolo::materials
