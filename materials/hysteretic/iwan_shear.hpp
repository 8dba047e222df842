#pragma once

// Hysteretic soil in large deformation: Iwan's parallel elastoplastic elements (iwan_elements.hpp; Joyner &
// Chen 1975, Bull. Seism. Soc. Am. 65, 1315-1336 for soil columns) on a backbone,
//
//     sigma = sigma_0 + K tr(eps) I + sum_i s_i,   s_i = 2 G_i dev(eps - eps_p,i),
//     sqrt(s_i : s_i / 2) <= tau_i.
//
// In simple shear the elements give a polygon through the backbone (backbone_polygon.hpp) and obey all four
// extended Masing rules without keeping any reversal point; in other directions they generalise both.
//
// sigma_0 is the stress in which the law is started. The elements start unloaded there: an initial static
// shear has no history, and the strength bounds the dynamic part of the stress alone.

#include "materials/elastic/elasticity.hpp"
#include "materials/elastic/linear_elastic.hpp"
#include "materials/hysteretic/backbone/backbone.hpp"
#include "materials/hysteretic/iwan_elements.hpp"
#include "materials/law/parameter.hpp"
#include "materials/law/points.hpp"
#include "materials/law/state_variable.hpp"
#include "materials/law/traits.hpp"
#include "materials/plastic/drucker_prager.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::materials {

/// Parallel elastoplastic elements. State of a point: their stresses, as in iwan_elements.hpp.
struct IwanShear {
  Elasticity elastic;                ///< at small strain; its shear modulus is the sum of the elements'
  std::vector<IwanElement> elements; ///< in order of growing yield strain
  LoopReduction loops = {};          ///< what unloading keeps of their damping
  std::optional<double> strength = std::nullopt; ///< largest shear stress, if one was given, Pa
};

/// Resolution and range of the elements' fit to the backbone.
struct IwanFit {
  std::size_t elements = 32;   ///< a multiple of iwan_group
  double largest_strain = 0.1; ///< engineering shear strain beyond which the stress stays the same
};

/// The elements that follow a backbone, whose G0 is that of `elastic`.
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
IwanShear iwan_shear(const Elasticity& elastic, const Backbone& backbone, const IwanFit& fit = {});

/// The elements that follow an MKZ backbone of modulus G0 = elastic.shear_modulus().
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
IwanShear iwan_shear(const Elasticity& elastic, double reference_strain, double beta, double exponent,
                     const IwanFit& fit = {});

/// Shear stress under monotonic simple shear from the unloaded state, Pa.
double monotonic_stress(const IwanShear& law, double strain);

Traits traits(const IwanShear& law);

/// The state block of a point.
std::span<const StateVariable> state_variables(const IwanShear& law);

/// The elastic soil to make an initial stress with: strain is measured from the initial state.
LinearElastic without_softening(const IwanShear& law);

/// The soil at its strength over F, static shear included, to which it is elastic; nothing if its backbone
/// was given no strength: what a modulus curve implies at large strain is none.
std::optional<DruckerPrager> with_reduced_strength(const IwanShear& law, double factor);

/// Advances stress, element stresses and plastic work of all points by one step.
void update(const IwanShear& law, const Points& points);

/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const IwanShear& law);

std::vector<ParameterValue> parameters(const IwanShear& law);

} // namespace tremolo::materials
