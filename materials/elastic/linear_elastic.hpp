#pragma once

// Linear elasticity in rate form: sigma_{n+1} = Q sigma_n Q^T + C : d_eps, with Q the step's rotation
// (objective_rate.hpp) and C : d_eps = 2 G dev(d_eps) + K tr(d_eps) I; in plane strain d_eps_zz = 0.

#include "materials/elastic/elasticity.hpp"
#include "materials/law/parameter.hpp"
#include "materials/law/points.hpp"
#include "materials/law/state_variable.hpp"
#include "materials/law/traits.hpp"

#include <span>
#include <vector>

namespace tremolo::materials {

/// Linear elastic soil. No state variables.
struct LinearElastic {
  Elasticity elastic;
};

Traits traits(const LinearElastic& law);

/// The state block of a point.
std::span<const StateVariable> state_variables(const LinearElastic& law);

/// Advances the stresses of all points by one step.
void update(const LinearElastic& law, const Points& points);

/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const LinearElastic& law);

/// The elastic constants are all that it takes.
std::span<const LawField<LinearElastic>> fields(const LinearElastic& law);

std::vector<ParameterValue> parameters(const LinearElastic& law);

} // namespace tremolo::materials
