#pragma once

// The factor of safety of ground under its own weight and the loads on it, by strength reduction: the largest
// F for which soil with
//
//     c / F,      tan(phi) / F,      s_u / F
//
// still comes to rest in the gravity stage (Zienkiewicz, Humpheson and Lewis 1975, Geotechnique 25, 671-689;
// Griffiths and Lane 1999, Geotechnique 49, 387-403). No slip surface is assumed: the soil that goes on
// moving just above F shows it.
//
// F is first bracketed by steps of 1.25 between 0.1 and 10 and then halved in. A model that carries its
// weight comes to rest within some tens of the period 4 H/c_s of a layer of its depth, and a long one near
// its limit takes more. One that has not come to rest after n = 60 periods counts as failed if its residual
// has come to a standstill,
//
//     r(n) >= 0.8 r(n/2),
//
// and else is given twice the time, up to eight times as much in all.

#include "mpm_domain/gravity/mechanism.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// Factors beyond these are not tried: soil with a tenth or with ten times its strength is another soil.
inline constexpr double least_factor = 0.1;
inline constexpr double largest_factor = 10.0;

/// A gravity stage with one factor.
struct StrengthTrial {
  double factor = 1.0;
  bool stands = false;
  bool ravels = false;   ///< soil less than two cells deep goes on moving all the same
  double residual = 0.0; ///< unbalanced over applied force at its end
};

struct FactorOfSafety {
  std::optional<double> stands;             ///< largest factor that was tried and stands; none: all fail
  std::optional<double> fails;              ///< smallest factor that does not; none: all stand
  std::vector<MovingPoint> mechanism = {};  ///< the soil with the factor `fails`
  std::vector<std::string> structures = {}; ///< those that do not rest on their friction then
};

/// Names of the soils of a model whose strength can be reduced, and of those that carry any load at rest.
struct ReducibleSoils {
  std::vector<std::string> reduced, kept;
};

ReducibleSoils reducible_soils(const Spec& spec);

/// Called as each trial ends.
using TrialProgress = std::function<void(const StrengthTrial&)>;

/// @param tolerance  of fails/stands - 1, 1
/// @throws std::invalid_argument without gravity, or without a soil whose strength can be reduced
FactorOfSafety factor_of_safety(const Spec& spec, double tolerance, const TrialProgress& progress);

/// Result of one trial: a lower or an upper bound on the factor.
/// @throws std::invalid_argument as factor_of_safety() does
FactorOfSafety try_factor(const Spec& spec, double factor, const TrialProgress& progress);

} // namespace tremolo::mpm_domain
