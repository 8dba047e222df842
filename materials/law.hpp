#pragma once

// The one interface of constitutive laws, used by columns and domain alike. A law is a plain struct of
// parameters; what it does are free functions on blocks of points. Choosing the law costs one branch per
// block, not per point.

#include "materials/iwan_shear.hpp"
#include "materials/linear_elastic.hpp"
#include "materials/masing_shear.hpp"
#include "materials/mohr_coulomb.hpp"
#include "materials/points.hpp"
#include "materials/state_variable.hpp"

#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace tremolo::materials {

using Law = std::variant<LinearElastic, MohrCoulomb, MasingShear, IwanShear>;

/// The name a case file uses for the law, e.g. "linear_elastic".
std::string_view name(const Law& law);

/// The state variables of one point, in the order of its state block.
std::span<const StateVariable> state_variables(const Law& law);

/// Advances stress and state of all points by one step of strain and rotation.
void update(const Law& law, const Points& points);

/// The law's elastic constants.
const Elasticity& elasticity(const Law& law);

/// The law to make an initial stress with, e.g. by gravity: held at its peak strength; elastic for the
/// hysteretic laws, whose strain is measured from the initial state; itself if it does not soften.
Law without_softening(const Law& law);

/// Refuses parameters outside their physical range.
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const Law& law);

} // namespace tremolo::materials
