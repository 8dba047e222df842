#pragma once

// The law of a column of soil in shear: sigma_xy by the extended Masing rules on a backbone (masing.hpp),
// normal stresses elastic,
//
//     sigma_xy <- sigma_xy + tau(gamma + d_gamma) - tau(gamma),      d_sigma_n = K tr(d_eps) + 2 G0
//     dev(d_eps).
//
// gamma is measured from the state in which the law is started: the initial stress, and with it an initial
// static shear, is carried along and has no history. Strength therefore bounds the dynamic part of the stress
// alone. Strains are small: the rotation of a step is ignored. The law for large deformation is IwanShear.

#include "materials/elastic/elasticity.hpp"
#include "materials/elastic/linear_elastic.hpp"
#include "materials/hysteretic/backbone/backbone.hpp"
#include "materials/hysteretic/masing.hpp"
#include "materials/law/parameter.hpp"
#include "materials/law/points.hpp"
#include "materials/law/state_variable.hpp"
#include "materials/law/traits.hpp"

#include <optional>
#include <span>
#include <vector>

namespace tremolo::materials {

/// Extended Masing rules in shear. State of a point: its MasingHistory.
struct MasingShear {
  Elasticity elastic;                                 ///< at small strain; its shear modulus is G0
  double reference_strain = 0.0;                      ///< gamma_r of the backbone, 1
  double beta = 1.0;                                  ///< of the backbone, 1
  double exponent = 1.0;                              ///< s of the backbone, 1, in [0.1, 1]
  std::optional<QuadraticShape> shape = std::nullopt; ///< of a backbone with a strength
  LoopReduction loops = {};                           ///< what unloading keeps of the damping

  Backbone backbone() const {
    return {elastic.shear_modulus(), reference_strain, beta, exponent, shape, loops};
  }
};

Traits traits(const MasingShear& law);

/// The state block of a point.
std::span<const StateVariable> state_variables(const MasingShear& law);

/// The elastic soil to make an initial stress with: strain is measured from the initial state.
LinearElastic without_softening(const MasingShear& law);

std::optional<Backbone> shear_backbone(const MasingShear& law);

/// Advances stress, history and plastic work of all points by one step.
void update(const MasingShear& law, const Points& points);

/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const MasingShear& law);

std::vector<ParameterValue> parameters(const MasingShear& law);

} // namespace tremolo::materials
