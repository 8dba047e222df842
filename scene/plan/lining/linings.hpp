#pragma once

// The linings of a case, as the plan describes them.
//
// A free ring of radius R ovals with (Love 1944, A treatise on the mathematical theory of elasticity, art.
// 293)
//
//     omega^2 = 36/5 EI/(m R^4).
//
// Beside ground of shear modulus G its flexibility ratio is F = G R^3/(3 EI) (Wang 1993): far above 1 a ring
// follows the ground, far below 1 the ground follows it. Marched explicitly, elements of length l would have
// a critical step, of their own and not the soil's,
//
//     min(l sqrt(m/EA), l sqrt(m_r (1 + P)/(3 EI))),     P = 12 EI/(GA_s l^2),
//
// m_r being the rotary mass. Linings are marched implicitly, which has no limit.

#include "scene/case.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::scene {

/// Properties of a ring only.
struct PlannedRing {
  double period = 0.0; ///< of free ovaling, s
  /// F in the soil at its springline, and that soil's name; none of soil whose stiffness is not in its law.
  double flexibility = 0.0;
  std::string soil;
};

/// A lining in numbers, per metre out of plane.
struct PlannedLining {
  std::string name;
  std::size_t elements = 0;
  std::size_t hinges = 0;
  double longest = 0.0;            ///< of its elements, m
  double axis = 0.0;               ///< length of its axis, m
  double mass = 0.0;               ///< kg/m
  double segments = 0.0;           ///< in which it meets soil, about
  double explicit_step = 0.0;      ///< that explicit elements would need, s
  std::optional<PlannedRing> ring; ///< of a circle
};

/// Cost per segment and step on one thread, ns; an order of magnitude.
inline constexpr double lining_segment_cost_ns = 15000.0;

/// Requires a case without errors.
std::vector<PlannedLining> plan_linings(const Case& scene);

/// "'ring' 14100 kg/m, 64 elements; ...", and what they cost.
std::string linings_effect_text(std::span<const PlannedLining> linings);

/// Some lines for each lining.
/// @param dt  the domain's step, s
std::string linings_text(const Case& scene, std::span<const PlannedLining> linings, double dt);

} // namespace tremolo::scene
