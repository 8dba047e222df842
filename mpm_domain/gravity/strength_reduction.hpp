#pragma once

// The factor of safety of ground under its own weight, by strength reduction: the largest F for which soil
// with
//
//     c / F,      tan(phi) / F
//
// still comes to rest in the gravity stage (Zienkiewicz, Humpheson and Lewis 1975, Geotechnique 25, 671-689;
// Griffiths and Lane 1999, Geotechnique 49, 387-403). No slip surface is assumed: the soil that goes on
// moving just above F shows it.
//
// F is first bracketed by steps of 1.25 and then halved in. A model that carries its weight comes to rest
// within some tens of the period 4 H/c_s of a layer of its depth; one that has not come to rest after 60
// counts as failed.

#include "mpm_domain/spec/spec.hpp"
#include "mpm_domain/spec/vector.hpp"

#include <functional>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// A gravity stage with one factor.
struct StrengthTrial {
  double factor = 1.0;
  bool stands = false;
  double residual = 0.0; ///< unbalanced over applied force at its end
};

/// A particle of soil that fails.
struct MovingPoint {
  Vector place;                ///< m
  double size = 0.0;           ///< a side of it, m
  Vector velocity;             ///< over that of the fastest particle, 1
  double plastic_strain = 0.0; ///< equivalent plastic deviatoric strain, 1; 0 for laws without
};

struct FactorOfSafety {
  double stands = 0.0;                ///< largest factor that was tried and carries the weight
  double fails = 0.0;                 ///< smallest factor that does not
  std::vector<MovingPoint> mechanism; ///< the soil with the factor `fails`
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
/// @throws std::runtime_error if no factor from 0.1 to 10 lies between standing and failing
FactorOfSafety factor_of_safety(const Spec& spec, double tolerance, const TrialProgress& progress);

} // namespace tremolo::mpm_domain
